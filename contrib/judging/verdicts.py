"""The judgement of one scene: the load factor, then states beside the limit."""
import random

import numpy

from judging.packing import Loads
from judging.program import COLLAPSE, SOLVED
from judging.programme import NONE, Answer, IntervalProgramme
from judging.proofs import mechanism_proof, state_proof
from judging.scenes import Scene, draw_loads

# The largest relative difference of factors, and by how much a proven bound
# may miss HiGHS's value, which has errors of its own.
LARGEST_DIFFERENCE, LARGEST_MISS = 1e-7, 1e-8
# Distances of states from the limit; up to the second number a program may
# have no verdict.
DISTANCES, NEAR = (1e-2, 1e-4, 1e-6, 1e-8), 1.001e-6
# Imbalances over the largest load that a program may take for rounding.
ROUNDING = 1e-10
# Errors of what is added up again from files.
LARGEST_ERROR = 1e-10

FORMULATIONS = {
    "least energy": [],
    "smoothed friction, compliant": ["smoothed friction", "Contact"],
    "smoothed friction, hard": ["smoothed friction", "Contact"],
    "linear program": [],
    "analytic centre, edge area": ["analytic centre", "Barrier weights"],
    "analytic centre, equal": ["analytic centre", "Barrier weights"]}


def settings_of(way):
    """The entries that choose a formulation with its variant."""
    formulation, _, variant = way.partition(", ")
    lines = [f"set Formulation = {formulation}"]
    if variant:
        section, entry = FORMULATIONS[way]
        lines += ["subsection Solver", f"subsection {section}",
                  f"set {entry} = {variant}", "end", "end"]
    return lines


class Judgement:
    """One scene on its way through the program and HiGHS.

    Counts what happens in a tally, and hands what is wrong to report(kind,
    run, words), where kind is "fault" or a word of what is tolerated.
    """
    scenes = Scene
    programme_of = IntervalProgramme
    # How many of the distances each scene has.
    n_distances = len(DISTANCES)

    def __init__(self, program, scene, report):
        self.program = program
        self.scene = scene
        self.choice = random.Random(f"{scene.name.replace('_', ' ')} runs")
        self.report = report
        self.n_states = 0
        self.kind = "refused"
        # Of HiGHS's factor from the one carried, and out of the bounds.
        self.difference = self.miss = 0.

    def run(self, name, text):
        return self.program.run(f"{self.scene.name}_{name}", text)

    def judge(self):
        """All of it."""
        if not self.has_packing():
            return
        self.draw()
        self.judge_factor()
        if self.kind == "bounded":
            self.judge_beside_limit()
        elif self.kind == "unbounded" and \
                self.programme.shortage(self.programme.dead) < NONE:
            for factor in (1., 1e3):
                self.state(factor * self.sense * self.programme.unit,
                           "carried", numpy.inf)
        elif self.kind == "not carried":
            self.state(0., "collapse", numpy.inf)

    def has_packing(self):
        """Whether the program makes the packing, which is then there."""
        if self.scene.drawing:
            self.program.write(f"{self.scene.name}.wkt", self.scene.drawing)
        packing = self.run("packing", self.scene.text())
        if packing.status != SOLVED:
            self.report("fault", packing, "the packing is refused")
            return False
        self.joints, self.packing = packing.packing()
        error = numpy.abs(self.packing.area / self.packing.written_area - 1.)
        if error.max() > LARGEST_ERROR:
            self.report("fault", packing, "areas are not those of polygons")
        return True

    def draw(self):
        """The loads, and what is asked of them."""
        self.dead, self.live = draw_loads(self.scene, self.packing)
        self.sense = self.choice.choice((1., -1.))
        self.entries = ["set Analysis = load factor", "subsection Load factor",
                        "set Direction = " +
                        ("greatest" if self.sense > 0. else "least")]
        self.given = self.dead, self.live
        if self.choice.random() < 0.1:
            self.entries.append("set Factor = all loads")
            self.live = self.dead.plus(1., self.live)
            self.dead = Loads()
        self.entries.append("end")
        self.programme = self.programme_of(
            self.joints, self.packing, self.dead.on(self.packing),
            self.live.on(self.packing))

    def judge_factor(self):
        """Class and factor by both, and the program's proofs."""
        for method in ("highs", "highs-ds", "highs-ipm"):
            self.expected = self.programme.judge(self.sense, method)
            if self.expected.kind != "doubtful":
                break
        self.kind = self.expected.kind
        dead, live = self.given
        run = self.asked = self.run(
            "factor", self.scene.text(self.entries, dead, live))
        self.found, self.bound = found_factor(run)
        if self.kind == "doubtful":
            self.report("doubtful", run, f"{self.expected.reason}; the program: "
                        f"{self.found.kind}")
            return
        words = self.disagreement(self.expected)
        if words:
            words = self.second_opinion(run, words)
        if words:
            self.report("fault", run, words)
        if self.kind == self.found.kind == "bounded":
            self.compare_factors()
            if run.verdict() == "undecided":
                self.report("undecided", run, f"the factor: {run.message}")
            for words in self.faults_of_proofs(run):
                self.report("fault", run, words)

    def price(self):
        """The change of the factor by imbalances of the largest load."""
        return self.expected.sensitivity * \
            self.programme.force_at(self.expected.factor)

    def compare_factors(self):
        """The differences, over the factor."""
        factor = self.expected.factor
        size = self.programme.scale_of(factor)
        self.difference = abs(self.found.factor - factor) / size
        self.miss = max(0., self.sense * (self.found.factor - factor),
                        self.sense * (factor - self.bound)) / size

    def disagreement(self, expected):
        """In which way the program's answer is another one, if it is."""
        if expected.kind != self.found.kind:
            return f"{self.found.kind}, expected {expected.kind}" + (
                f" with factor {expected.factor!r}"
                if expected.kind == "bounded" else "")
        if expected.kind != "bounded":
            return ""
        size = self.programme.scale_of(expected.factor)
        room = LARGEST_MISS * size + 2. * expected.error
        lower, upper = self.found.factor, self.bound
        if self.sense * (lower - expected.factor) > room or \
                self.sense * (expected.factor - upper) > room:
            return f"{lower!r} to {upper!r} does not enclose " \
                f"{expected.factor!r} (error {expected.error:.1e})"
        if abs(lower - expected.factor) > LARGEST_DIFFERENCE * size + room:
            return f"{lower!r} to {upper!r} is wide, expected " \
                f"{expected.factor!r}"
        return ""

    def second_opinion(self, run, words):
        """Nothing, if another method of HiGHS or two proofs agree with the
        program; else the words."""
        for method in ("highs-ds", "highs-ipm"):
            other = self.programme.judge(self.sense, method)
            if not self.disagreement(other):
                self.report("overruled", run, f"{words}; {method} agrees")
                self.take(other)
                return ""
            words += f"; {method}: {other.kind} {other.factor!r}"
        if self.found.kind == "bounded" and \
                "wide" not in words and not [*self.faults_of_proofs(run)]:
            self.report("overruled", run, f"{words}; the proofs hold")
            self.take(Answer("bounded", "", self.found.factor, 0.,
                             self.expected.sensitivity))
            return ""
        return words

    def take(self, answer):
        """Another answer for the expected one."""
        self.expected, self.kind = answer, answer.kind

    def faults_of_proofs(self, run):
        """What is wrong with a load factor's two proofs."""
        programme = self.programme
        factor = self.found.factor
        loads = self.dead.plus(factor, self.live).on(self.packing)
        written = run.loads()[:, :3 if self.scene.rotations else 2]
        error = numpy.abs(written - loads[:, :written.shape[1]]).max()
        if error > LARGEST_ERROR * (numpy.abs(loads).max() or 1.):
            yield f"the loads differ by {error:.1e}"
        if self.sense * (factor - self.bound) > \
                LARGEST_ERROR * programme.scale_of(self.bound):
            yield f"{factor!r} is carried and beyond the bound {self.bound!r}"
        state = state_proof(run, programme, programme.at(factor))
        worth = state.error() * self.price() / programme.scale_of(factor)
        if worth > LARGEST_MISS or state.error() > ROUNDING or \
                not state.agrees(run.summary["certificate"]):
            yield f"the state proves nothing: {state}"
        mechanism = mechanism_proof(run, programme)
        miss = abs(mechanism.factor() - self.bound)
        if not mechanism.holds() or self.sense * mechanism.live_work <= 0. or \
                miss > LARGEST_ERROR * programme.scale_of(self.bound):
            yield f"the mechanism does not prove {self.bound!r}: " \
                f"{mechanism.factor()!r}, {mechanism}"

    def judge_beside_limit(self):
        """States at all distances on both sides."""
        if self.found.kind != "bounded":
            inner = outer = self.expected.factor
        else:
            limits = [self.expected.factor, self.found.factor, self.bound]
            inner, outer = sorted((min(limits), max(limits)),
                                  key=lambda limit: self.sense * limit)
        scale = self.programme.scale_of(self.expected.factor)
        needed = scale / self.price() if self.price() > 0. else numpy.inf
        for distance in self.choice.sample(DISTANCES, self.n_distances):
            step = self.sense * distance * scale
            if self.has_room(inner - step):
                self.state(inner - step, "carried", distance, needed)
            self.state(outer + step, "collapse", distance, needed)

    def has_room(self, factor):
        """Whether a factor on the inner side is farther from the other end."""
        other = self.programme.optimum(-self.sense, self.programme.unit,
                                       self.programme.unit)
        away = self.sense * (self.expected.factor - factor)
        return other.kind == "unbounded" or (
            other.kind == "bounded" and
            self.sense * (factor - other.factor) > away)

    def state(self, factor, expected, distance, needed=numpy.inf):
        """One verdict; needed is the imbalance, over distance and largest
        load, that makes up for the distance."""
        run, way = self.state_run(factor)
        if run.verdict() == "clamped":
            run, way = self.state_run(factor, "least energy")
        verdict = run.verdict()
        self.n_states += 1
        words = f"{way}: {verdict}, expected {expected} at {distance:.0e} " \
            f"from {self.expected.factor!r}"
        if verdict == expected:
            self.judge_proof(run, factor, words)
        elif verdict == "undecided" or distance * needed < ROUNDING:
            tolerated = distance <= NEAR or distance * needed < ROUNDING
            self.report("undecided" if tolerated else "fault", run,
                        f"{words}; {run.message or run.summary.get('within')}")
        else:
            self.report("fault", run, words + self.proof(run, factor))

    def state_run(self, factor, way=None):
        """A run with the loads at a factor, and the way that it goes."""
        settings, word = [], "interior point"
        if self.scene.law == "Tresca":
            word = way or self.choice.choice([*FORMULATIONS])
            settings = settings_of(word)
        loads = self.dead.plus(factor, self.live)
        return self.run(f"state_{self.n_states}",
                        self.scene.text(settings, loads)), word

    def judge_proof(self, run, factor, words):
        """The state or the mechanism that an expected verdict comes with."""
        if run.status == SOLVED:
            state = state_proof(run, self.programme, self.programme.at(factor))
            if not state.agrees(run.summary["certificate"]):
                self.report("fault", run, f"{words}; {state}")
        elif run.status == COLLAPSE:
            mechanism = mechanism_proof(run, self.programme)
            work = mechanism.dead_work + factor * mechanism.live_work
            if not (mechanism.holds() and work > mechanism.dissipation):
                self.report("fault", run, f"{words}; {mechanism}")

    def proof(self, run, factor):
        """What the proof of a wrong verdict is worth."""
        if run.status == SOLVED:
            at = self.programme.at(factor)
            return f"; {state_proof(run, self.programme, at)}"
        if run.status == COLLAPSE:
            return f"; {mechanism_proof(run, self.programme)}"
        return f"; {run.message}"


def found_factor(run):
    """The program's answer with the factor carried, and its bound."""
    if run.status == COLLAPSE:
        return Answer("not carried"), None
    if run.status != SOLVED:
        return Answer(f"{run.verdict()} ({run.message})"), None
    factor = run.summary["load_factor"]
    if factor["unbounded"]:
        return Answer("unbounded"), None
    if factor["bound"] is None:
        return Answer("without a bound", "", factor["carried"]), None
    return Answer("bounded", "", factor["carried"]), factor["bound"]
