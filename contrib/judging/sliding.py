"""The judgement of one wall whose friction has no dilatancy: the program's
factor beside those of collapses by linear programmes, and states below it."""
import time


from judging.dilatancy import WithoutDilatancy
from judging.facades import FacadeScene
from judging.program import SOLVED
from judging.programme import Programme
from judging.proofs import state_proof, written_forces, written_motion
from judging.verdicts import Judgement

# Of the program's factor those with a state.
SHARES = (0.5, 0.9, 0.99)
# By how much the program's factor may be less than that of the largest collapse
# that is known, over it; of bounds and of pairs what is no fault.
LARGEST_LOSS, LARGEST_MISS, LARGEST_ERROR = 1e-2, 1e-6, 1e-5
# Of the forces of a state, which are the end of an iteration, over the largest
# load.
LARGEST_IMBALANCE = 1e-8


class SlidingJudgement(Judgement):
    """One wall on its way through the program and HiGHS.

    The difference that a tally has is that of the program's factor from the
    largest one that is known to have a collapse, where it is less.
    """
    scenes = FacadeScene

    def judge(self):
        """All of it."""
        if not self.has_packing():
            return
        self.dead, self.live = self.scene.draw_loads(self.packing)
        self.programme = Programme(self.joints, self.packing,
                                   self.dead.on(self.packing),
                                   self.live.on(self.packing))
        began = time.monotonic()
        run = self.run("factor", self.scene.text(
            ["set Analysis = load factor"], self.dead, self.live))
        seconds = time.monotonic() - began
        if run.status != SOLVED:
            self.kind = "not carried"
            if self.programme.judge(1.).kind != "not carried":
                self.report("fault", run, f"{run.verdict()}: {run.message}")
            return
        found = run.summary["load_factor"]
        self.factor = found["carried"]
        if found["unbounded"]:
            self.kind = "unbounded"
            if self.programme.judge(1.).kind != "unbounded":
                self.report("fault", run, "unbounded")
            return
        self.kind = "bounded"
        self.compare(run, found, seconds)
        self.judge_state(run, self.factor)
        # The program says itself that smaller ones have no state.
        self.is_doubted = any(tried < self.factor for tried in
                              found["tried"]["without_state"])
        for share in SHARES:
            self.n_states += 1
            self.judge_below(share)

    def compare(self, run, found, seconds):
        """The program's factor with those of the pairs."""
        scheme = WithoutDilatancy(self.programme)
        dilating = scheme.associated()
        if dilating is None:
            self.report("doubtful", run, "HiGHS has no bound")
            return
        size = self.programme.scale_of(dilating.factor)
        if found["bound"] is None or \
                abs(found["bound"] - dilating.factor) > LARGEST_MISS * size:
            self.report("fault", run, f"the bound is {found['bound']!r}, "
                        f"expected {dilating.factor!r}")
        if self.factor > dilating.factor + LARGEST_MISS * size:
            self.report("fault", run, f"{self.factor!r} is beyond "
                        f"{dilating.factor!r}")
        pairs = [scheme.search(least) for least in (True, False)]
        for pair, word in zip(pairs, ("least", "largest")):
            if pair is None or pair.error() > LARGEST_ERROR:
                self.report("doubtful", run, f"of the {word} collapse " +
                            (f"{pair.error():.1e} is left at "
                             f"{pair.factor!r}" if pair else "nothing"))
        self.print(seconds, dilating.factor, pairs)
        known = [pair.factor for pair in pairs
                 if pair is not None and pair.error() <= LARGEST_ERROR]
        self.difference = max(0., max(known, default=self.factor) -
                              self.factor) / size
        if known and self.factor < max(known) - LARGEST_LOSS * size:
            self.report("fault", run, f"{self.factor!r} is less than the "
                        f"collapses from {min(known)!r} to {max(known)!r}")
        if "own_collapse" in found:
            self.compare_collapse(scheme, run, found["own_collapse"])

    def compare_collapse(self, scheme, run, said):
        """The pair of the program's forces and its mechanism."""
        motion = written_motion(run, self.programme, "mechanism.csv")
        work = self.programme.live @ motion
        jumps = (self.programme.matrix.T @ motion / work).reshape(-1, 3)
        pair = scheme.pair(
            self.factor,
            written_forces(run, self.joints).reshape(-1, 3), jumps)
        if not pair.error() <= LARGEST_ERROR or abs(
                said["factor"] - self.factor) > \
                LARGEST_ERROR * self.programme.scale_of(self.factor):
            self.report("fault", run, f"forces and mechanism are no collapse: "
                        f"{pair.excess:.1e}, {pair.idle_work:.1e}, "
                        f"{pair.closing:.1e}, {said}")

    def print(self, seconds, bound, pairs):
        """One line on a wall."""
        found = [f"{pair.factor / bound:.6f} ({pair.error():.0e}, "
                 f"{pair.programmes} programmes, {pair.seconds:.1f} s)"
                 if pair else "none" for pair in pairs]
        print(f"{self.scene.name}: {len(self.packing)} blocks, of "
              f"{bound:.8g} the program {self.factor / bound:.6f} "
              f"({seconds:.1f} s), collapses from {found[0]} to {found[1]}",
              flush=True)

    def judge_state(self, run, factor):
        """The forces of a state."""
        state = state_proof(run, self.programme, self.programme.at(factor))
        if not state.error() < LARGEST_IMBALANCE or \
                not state.agrees(run.summary["certificate"]):
            self.report("fault", run, f"the state proves nothing: {state}")

    def judge_below(self, share):
        """A state at a share of the program's factor."""
        factor = share * self.factor
        run = self.run(f"state_{share}", self.scene.text(
            loads=self.dead.plus(factor, self.live)))
        if run.verdict() != "carried":
            if self.is_doubted:
                return
            self.report("fault", run, f"{run.verdict()}, expected a state at "
                        f"{share} of {self.factor!r}; {run.message}")
            return
        self.judge_state(run, factor)
