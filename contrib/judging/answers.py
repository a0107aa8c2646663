"""What the answers to one question say of each other: verdict, factor, forces.
"""
import dataclasses

import numpy

from judging.program import SOLVED

# Between two runs: a load factor stops at a width of 1e-8 between its proofs,
# the search without dilatancy, whose factor no proof bounds, at 1e-6, and the
# forces of a state at an imbalance of 1e-10 of the loads, which joints that
# slide multiply.
LARGEST = {"bound": 1e-7, "factor": 1e-7, "force": 1e-6}
LARGEST_WITHOUT_DILATANCY = 3e-6
# Selections that are any state, of which the forces need not agree.
ANY_STATE = ("one of the states", "linear program")


@dataclasses.dataclass
class Answer:
    """The end of a run: its verdict, and the numbers by kind."""
    verdict: str
    forces: numpy.ndarray
    numbers: dict
    has_one_state: bool
    dilates: bool

    def differences(self, other):
        """The largest relative difference from another answer, by kind."""
        found = {}
        for kind in self.numbers.keys() & other.numbers.keys():
            a, b = self.numbers[kind], other.numbers[kind]
            size = max(abs(a), abs(b))
            found[kind] = abs(a - b) / size if size > 0. else 0.
        if len(self.forces) and self.forces.shape == other.forces.shape:
            size = max(abs(self.forces).max(), abs(other.forces).max())
            if size > 0.:
                found["force"] = abs(self.forces - other.forces).max() / size
        return found

    def faults(self, other):
        """What differs from another answer by more than it may, in words."""
        if self.verdict != other.verdict:
            return [f"{self.verdict} and {other.verdict}"]
        words = []
        for kind, difference in self.differences(other).items():
            if kind == "force" and not self.has_one_state:
                continue
            largest = LARGEST_WITHOUT_DILATANCY if kind == "factor" \
                and not self.dilates else LARGEST[kind]
            if not difference <= largest:
                words.append(f"{kind} {difference:.1e}")
        return words


def answer_of(run):
    """The answer of a Run."""
    verdict = run.verdict()
    if run.status != SOLVED:
        return Answer(verdict, numpy.zeros(0), {}, False, True)
    rows = run.table("interfaces.csv")
    names = [name for name in ("normal_force", "tangential_force",
                               "normal_force_0", "normal_force_1")
             if rows and name in rows[0]]
    forces = numpy.array([[float(row[name]) for name in names]
                          for row in rows])
    factor = run.summary.get("load_factor", {})
    numbers = {"factor": factor.get("carried"), "bound": factor.get("bound")}
    if factor.get("unbounded"):
        verdict += ", unbounded"
        numbers = {}
    return Answer(verdict, forces,
                  {kind: x for kind, x in numbers.items() if x is not None},
                  not factor and
                  not run.summary["selection"].startswith(ANY_STATE),
                  run.summary.get("friction_law") != "Coulomb")
