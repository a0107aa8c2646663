"""The judgement of one scene in space whose friction has no dilatancy: its
factor beside that with dilatancy, the collapse that it is, and states below it.

No theorem tells which factor is right, so that what a run says is added up
again: forces within the cones of friction, and a motion that goes with them.
"""
import numpy

from judging.program import COLLAPSE, SOLVED
from judging.space import columns
from judging.space_questions import FurtherJudgement, FurtherScene

# Of the factor those with a state.
SHARES = (0.5, 0.9, 0.99)
# Of the factor beyond that with dilatancy; of the collapse, over the factor
# with dilatancy and over the work of friction; of elastic forces, over the largest,
# which get a share of up to 1e-5 of others to be within their limits.
LARGEST_MISS, LARGEST_ERROR, LARGEST_DIFFERENCE = 1e-8, 1e-4, 1e-4
# Of joints that close in a motion of the size one.
LARGEST_CLOSING = 1e-9
NO_DILATANCY = ["subsection Friction", "set Law = Coulomb", "end"]
LAWS = ("Coulomb", "Coulomb, c")


class SlidingScene(FurtherScene):
    """A scene with Coulomb's friction."""
    laws = LAWS


class SpaceSlidingJudgement(FurtherJudgement):
    """One scene on its way through the program.

    The difference that a tally has is by how much the factor is less than that
    with dilatancy, and the miss how far its forces and its mechanism are from a
    collapse."""
    question = "dilatancy"
    scenes = SlidingScene

    def judge(self):
        self.kind = "not carried"
        dilating = self.run("dilating")
        dead = self.run("dead", 0., NO_DILATANCY)
        if dead.status not in (SOLVED, COLLAPSE):
            self.report("undecided", dead, dead.message)
            return
        self.take(dead)
        self.judge_state(dead, 0.)
        run = self.run("factor", None, NO_DILATANCY)
        bound = dilating.summary.get("load_factor")
        if run.status != SOLVED:
            known = dilating.status == SOLVED and not bound["unbounded"]
            self.report("undecided" if known or run.status != COLLAPSE else
                        "fault" if dilating.status == SOLVED else "collapse",
                        run, f"{run.verdict()}: {run.message}")
            return
        if bound is None:
            self.report("fault", run, "carried, which it is not with dilatancy")
            return
        found = run.summary["load_factor"]
        if found["unbounded"] or bound["unbounded"]:
            self.kind = "unbounded"
            if found["unbounded"] != bound["unbounded"]:
                self.report("fault", run, f"unbounded: {found['unbounded']}, "
                            f"with dilatancy {bound['unbounded']}")
            return
        self.kind = "bounded"
        self.compare_factors(run, found, bound)
        factor = found["carried"]
        self.judge_forces(run, factor)
        if "own_collapse" in found:
            self.compare_collapse(run, found, bound["bound"])
        else:
            self.report("no collapse", run, found["meaning"])
        self.judge_below(found, factor)

    def compare_factors(self, run, found, bound):
        """With that of friction with dilatancy."""
        sense = 1. if self.scene.sense == "greatest" else -1.
        size = max(abs(bound["bound"]), 1e-3)
        more = sense * (found["carried"] - bound["bound"]) / size
        self.difference = max(0., -more)
        if more > LARGEST_MISS:
            self.report("fault", run, f"{found['carried']!r} is beyond "
                        f"{bound['bound']!r}")
        if abs(found["bound"] - bound["bound"]) > 1e-6 * size:
            self.report("fault", run, f"the bound is {found['bound']!r}, not "
                        f"{bound['bound']!r}")

    def forces(self, run):
        """Of each point the pressure from the tip of its cone, the tangential
        force, and its limit."""
        b, scene = self.blocks, self.scene
        force = columns(run.table("interface_points.csv"),
                        ["force_x", "force_y", "force_z"])
        normal = b.normal[b.joint]
        across = (force * normal).sum(axis=1)
        size = b.share * b.area[b.joint]
        pressure = numpy.where(b.presses, scene.tension * size - across, 0.)
        strength = max(scene.strength - scene.coefficient * scene.tension, 0.)
        limit = numpy.where(b.presses, scene.coefficient *
                            numpy.maximum(pressure, 0.), strength * size)
        return pressure, force - across[:, None] * normal, limit

    def split(self, run):
        """The opening at each point, the sliding, and the motion."""
        b = self.blocks
        jump, motion = self.jumps(run)
        normal = b.normal[b.joint]
        opening = (jump * normal).sum(axis=1)
        return opening, jump - opening[:, None] * normal, motion

    def compare_collapse(self, run, found, bound):
        """The pair of the forces and the mechanism."""
        b, scene = self.blocks, self.scene
        pressure, shear, limit = self.forces(run)
        opening, slip, motion = self.split(run)
        opening *= b.presses
        work = limit * numpy.linalg.norm(slip, axis=1)
        # What forces resist that go with the motion, less what they do: the
        # force on c- is along the jump of c+.
        idle = numpy.abs(pressure * opening).sum() + \
            numpy.abs(work - (shear * slip).sum(axis=1)).sum()
        tension = (scene.tension * b.share * b.area[b.joint] * opening).sum()
        of_live = (self.live * motion).sum()
        own = (work.sum() + tension - (self.dead * motion).sum()) / of_live
        closing = max(-opening.min(), 0.) / numpy.abs(motion).max()
        size = max(abs(bound), 1e-3)
        sense = 1. if scene.sense == "greatest" else -1.
        self.miss = max(abs(own - found["carried"]) / size,
                        idle / (work.sum() + abs(own * of_live)))
        said = found["own_collapse"]["factor"]
        if not (self.miss <= LARGEST_ERROR and closing <= LARGEST_CLOSING and
                sense * of_live > 0. and abs(own - said) <= 1e-9 * size):
            self.report("fault", run, f"no collapse: it proves {own!r}, said is "
                        f"{said!r} at {found['carried']!r}; idle work "
                        f"{self.miss:.1e}, it closes by {closing:.1e}")

    def judge_below(self, found, factor):
        """States at shares of the factor."""
        sense = 1. if self.scene.sense == "greatest" else -1.
        is_doubted = any(sense * (factor - tried) > 0. for tried in
                         found["tried"]["without_state"])
        for share in SHARES:
            self.n_states += 1
            run = self.run(f"state_{share}", share * factor, NO_DILATANCY)
            if run.status == SOLVED:
                if run.verdict() != "carried":
                    self.report("within", run, f"{run.summary['within']:.1e} "
                                f"at {share} of {factor!r}")
                self.judge_forces(run, share * factor)
                self.judge_elastic(run)
            else:
                self.report("undecided" if is_doubted else "fault", run,
                            f"{run.verdict()} at {share} of {factor!r}: "
                            f"{run.message}")

    def judge_state(self, run, factor):
        super().judge_state(run, factor)
        if run.status == SOLVED:
            self.judge_elastic(run)

    def judge_elastic(self, run):
        """Whether forces are those of elastic joints with their own
        strengths."""
        if "elastic joints" not in run.summary["selection"]:
            return
        b = self.blocks
        pressure, shear, limit = self.forces(run)
        opening, slip, _ = self.split(run)
        rows = run.table("interfaces.csv")
        distance = columns(rows, ["distance"])[b.joint, 0]
        size = b.share * b.area[b.joint]
        stiffness = size / distance
        # Of which vertices and cells have half each, where both slide.
        has_cells = self.scene.strength > \
            self.scene.coefficient * self.scene.tension
        part = 0.5 if has_cells else 1.
        expected = numpy.maximum(
            self.scene.tension * size - stiffness * opening, 0.) * b.presses
        slide = numpy.linalg.norm(slip, axis=1)
        of_slip = numpy.minimum(part * stiffness, limit / numpy.maximum(
            slide, 1e-300))[:, None] * slip
        largest = max(numpy.abs(pressure).max(), numpy.abs(shear).max(), 1e-300)
        away = max(numpy.abs(pressure - expected).max(),
                   numpy.abs(shear - of_slip).max()) / largest
        if away > LARGEST_DIFFERENCE:
            self.report("fault", run, f"forces differ by {away:.1e} of the "
                        "largest from those of the motion")
