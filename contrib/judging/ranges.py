"""The ranges of all forces of one scene, by the program and by HiGHS."""
import numpy

from judging.program import SOLVED
from judging.programme import Programme, minimise
from judging.scenes import Scene, draw_loads

# Of bounds, over the largest load on a row.
LARGEST_DIFFERENCE = 1e-8
# HiGHS's words for an optimum and for none.
OPTIMAL, UNBOUNDED = 0, 3


class RangeJudgement:
    """One scene: each force's least and greatest value over all states.

    Has what a Tally counts: of the kinds "bounded" are scenes that are
    compared, and "not carried" the others.
    """

    def __init__(self, program, seed, k, report):
        self.program = program
        self.scene = Scene(seed, k)
        self.report = report
        self.n_states = 0
        self.kind = "not carried"
        self.difference = self.miss = 0.

    def judge(self):
        name = f"{self.scene.name}_ranges"
        if self.scene.drawing:
            self.program.write(f"{self.scene.name}.wkt", self.scene.drawing)
        packing = self.program.run(f"{name}_packing", self.scene.text())
        if packing.status != SOLVED:
            self.report("fault", packing, "the packing is refused")
            return
        joints, cells = packing.packing()
        loads, _ = draw_loads(self.scene, cells)
        settings = ["set Formulation = least energy"] \
            if self.scene.law == "Tresca" else []
        text = self.scene.text(
            [*settings, "subsection Ranges", "set Where = 1", "end"], loads)
        run = self.program.run(name, text)
        if run.verdict() != "carried":
            if "range" in run.message:
                self.report("undecided", run, run.message)
            return
        self.kind = "bounded"
        written = loads.on(cells)
        # Of live loads there is no question.
        programme = Programme(joints, cells, written,
                              numpy.ones_like(written))
        self.compare(run, programme)

    def compare(self, run, programme):
        """Every end of a range."""
        force = numpy.abs(programme.dead).max() or 1.
        n = programme.joints.n_contacts
        rows = run.table("interfaces.csv")
        for joint, row in enumerate(rows):
            first = (n + 1) * joint
            for symbol, which in (("p", range(first, first + n)),
                                  ("q", [first + n])):
                for end, sign in (("min", 1.), ("max", -1.)):
                    cost = numpy.zeros(programme.matrix.shape[1])
                    cost[list(which)] = sign
                    self.compare_end(run, programme, force, cost, sign,
                                     f"{symbol}_{end}", row, joint)

    def compare_end(self, run, programme, force, cost, sign, name, row, joint):
        """One of them."""
        limits = programme.admissible.times(1. / force)
        for method in ("highs", "highs-ds", "highs-ipm"):
            found = minimise(cost, programme.matrix, -programme.dead / force,
                             limits, method, [])
            if found.status in (OPTIMAL, UNBOUNDED):
                break
        else:
            self.report("doubtful", run, f"HiGHS on {name} of {joint}: "
                        f"{found.message}")
            return
        expected = -sign * numpy.inf if found.status == UNBOUNDED \
            else sign * found.fun * force
        self.n_states += 1
        value = float(row[name])
        if value == expected:
            return
        difference = abs(value - expected) / force
        self.difference = max(self.difference, difference)
        if not difference <= LARGEST_DIFFERENCE:
            self.report("fault", run, f"{name} of interface {joint} is "
                        f"{value!r}, expected {expected!r}")
