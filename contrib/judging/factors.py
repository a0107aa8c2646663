"""The judgement of one scene of which zero need not be a factor that is carried:
both ends of the interval of factors, wherever it is, or that there is none."""
import numpy

from judging.packing import number
from judging.program import COLLAPSE
from judging.programme import CLEAR, NONE
from judging.proofs import mechanism_proof, state_proof
from judging.turned_scenes import TurnedScene
from judging.verdicts import LARGEST_ERROR, ROUNDING, Judgement

# What a summary says where the live loads are a prop.
PROPPED = "not carried without"
# The work of live loads in the mechanism of a scene that no factor helps, over
# that of the same forces all along their displacements.
LARGEST_WORK = 1e-9
DIRECTIONS = {1.: "greatest", -1.: "least"}


class FactorJudgement(Judgement):
    """One scene on its way through the program and HiGHS, twice."""
    scenes = TurnedScene
    is_propped = False

    def run(self, name, text):
        return super().run(name if name == "packing" else
                           f"{DIRECTIONS[self.sense]}_{name}", text)

    def judge(self):
        """All of it."""
        if not self.has_packing():
            return
        self.draw()
        self.interval = {sense: self.programme.judge(sense)
                         for sense in DIRECTIONS}
        kinds = []
        for self.sense in DIRECTIONS:
            self.judge_factor()
            kinds.append(self.kind)
            if self.kind == "bounded":
                self.judge_beside_limit()
            elif self.kind == "not carried":
                self.state(0., "collapse", numpy.inf)
        self.kind = max(kinds, key=("not carried", "doubtful", "unbounded",
                                    "bounded").index)

    def draw(self):
        """The loads."""
        self.dead, self.live = self.given = self.scene.draw_loads(self.packing)
        self.programme = self.programme_of(
            self.joints, self.packing, self.dead.on(self.packing),
            self.live.on(self.packing))
        self.shortage = self.programme.shortage(self.programme.dead)
        self.sense = 1.

    @property
    def entries(self):
        return ["set Analysis = load factor", "subsection Load factor",
                f"set Direction = {DIRECTIONS[self.sense]}", "end"]

    def judge_factor(self):
        """Class and factor by both, the program's proofs, and what it says of
        the dead loads alone."""
        super().judge_factor()
        self.is_propped = self.kind in ("bounded", "unbounded") and \
            self.shortage > CLEAR
        if self.kind != self.found.kind:
            return
        for words in self.faults_of_words():
            self.report("fault", self.asked, words)
        if self.kind == "not carried":
            for words in self.faults_of_collapse(self.asked):
                self.report("fault", self.asked, words)
        elif self.kind == "unbounded":
            for words in self.faults_of_state(self.asked):
                self.report("fault", self.asked, words)

    def faults_of_words(self):
        """Whether the summary says that the live loads are a prop."""
        if self.asked.status == COLLAPSE:
            return
        said = PROPPED in str(self.asked.summary)
        if said and self.shortage < NONE:
            yield f"'{PROPPED}' is said of loads that are carried"
        elif not said and self.is_propped:
            yield f"'{PROPPED}' is not said of loads that lack " \
                f"{self.shortage:.1e}"

    def faults_of_collapse(self, run):
        """What is wrong with the proof that no factor is carried."""
        programme = self.programme
        proof = mechanism_proof(run, programme)
        possible = proof.size * numpy.abs(programme.live).sum()
        if not proof.holds() or \
                abs(proof.live_work) > LARGEST_WORK * possible:
            yield f"the mechanism does not prove that none is carried: {proof}"
        elif not proof.dead_work > proof.dissipation:
            yield f"the mechanism proves nothing: {proof}"

    def faults_of_state(self, run):
        """What is wrong with the forces of an unbounded factor."""
        at = run.summary["load_factor"]["forces_at"]
        state = state_proof(run, self.programme, self.programme.at(at))
        if state.error() > ROUNDING or \
                not state.agrees(run.summary["certificate"]):
            yield f"the state at {number(at)} proves nothing: {state}"

    def compare_factors(self):
        largest = self.difference, self.miss
        super().compare_factors()
        self.difference = max(self.difference, largest[0])
        self.miss = max(self.miss, largest[1])

    def has_room(self, factor):
        """Whether a factor on the inner side is farther from the other end."""
        other = self.interval[-self.sense]
        away = self.sense * (self.expected.factor - factor)
        return other.kind == "unbounded" or (
            other.kind == "bounded" and
            self.sense * (factor - other.factor) > away)
