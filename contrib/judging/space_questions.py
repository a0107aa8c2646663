"""What the questions beside load factors in space begin with: scenes, some of
them between supports on several sides, and loads that they carry."""
import numpy

from judging.blocks_in_space import SpaceScene
from judging.program import COLLAPSE, SOLVED
from judging.space import Blocks, PolygonProgramme, SpaceJudgement

# Of a load factor that is bounded, the share that is asked for.
SHARES = (0., 0., 0.3, 0.9, 0.999)
# Other supports, of walls and of grains.
CLAMPS = {"wall": ("z < 1e-9 || nx > 0.99", "z < 1e-9 || abs(nx) > 0.99",
                   "abs(nx) > 0.99"),
          "grains": ("nz < -0.99", "abs(nz) > 0.99", "nx < -0.99 || nz < -0.99",
                     "abs(nx) > 0.99 || abs(nz) > 0.99")}
SHARE_OF_CLAMPED = 0.5
MOST_GRAINS = 8


class FurtherScene(SpaceScene):
    """A scene that is small enough for many linear programmes; some have
    supports on several sides."""
    can_float = True

    def __init__(self, seed, k):
        super().__init__(seed, k)
        self.cells = 1
        self.clamp()

    def clamp(self):
        """Other supports, perhaps."""
        clamps = CLAMPS.get(self.kind, ())
        must = self.kind == "grains" and not self.can_float
        if clamps and (must or self.draw.random() < SHARE_OF_CLAMPED):
            self.supports = self.draw.choice(clamps)

    def wall(self):
        n, m = self.draw.randint(2, 3), self.draw.randint(2, 4)
        entries = {"Bond": "running", "Length": n, "Thickness": 0.5,
                   "Height": 0.3 * m, "Brick length": 1, "Brick width": 0.5,
                   "Brick height": 0.3}
        return self.section("wall", entries), "z < 1e-9"

    def dome(self):
        draw = self.draw
        entries = {"Thickness": draw.uniform(0.1, 0.3), "Courses": 2,
                   "Sectors": draw.randint(3, 5),
                   "Bond": draw.choice(("running", "stack"))}
        return self.section("dome", entries), "nz < -0.5 && z < 1e-9"

    def stairs(self):
        entries = {"Steps": 2, "Courses above": 1,
                   "Bearing": self.draw.uniform(0.1, 0.25)}
        return self.section("stairs", entries), "z < 1e-9 && nz < -0.5"

    def grains(self):
        entries = {"Number of points": self.draw.randint(3, MOST_GRAINS),
                   "Seed": self.draw.randrange(1000)}
        return self.section("Voronoi", entries), "0"


class FurtherJudgement(SpaceJudgement):
    """One scene with loads that it carries, and a question about it.

    Of the kinds "bounded" are scenes that are compared.
    """
    scenes = FurtherScene
    # The word for it in names of files.
    question = ""

    def run(self, name, factor=None, further=()):
        return self.program.run(f"{self.scene.name}_{self.question}_{name}",
                                self.scene.text(factor, further))

    def judge(self):
        self.kind = "not carried"
        state = self.run("dead", 0.)
        if state.status == COLLAPSE:
            return
        if state.status != SOLVED:
            self.report("undecided", state, state.message)
            return
        self.take(state)
        factor = self.factor()
        self.loads = self.dead + factor * self.live
        run = self.run("asked", factor, self.lines())
        if run.status == SOLVED:
            self.kind = "bounded"
            self.compare(run, factor)
        else:
            self.judge_refusal(run)

    def take(self, run):
        """Blocks and loads from a run."""
        self.blocks = Blocks(run)
        if self.blocks.check() > 1e-9:
            self.report("fault", run, "shares do not add up to one")
        self.programme = PolygonProgramme(self.scene, self.blocks)
        self.dead = self.blocks.loads(self.scene.dead)
        self.live = self.blocks.loads(self.scene.live)

    def factor(self):
        """A share of the factor of the live loads."""
        share = self.choice.choice(SHARES)
        if share == 0.:
            return 0.
        found = self.run("factor").summary.get("load_factor")
        if found is None:
            return 0.
        if found["unbounded"]:
            sense = 1. if self.scene.sense == "greatest" else -1.
            return sense * share
        return share * found["carried"]

    def lines(self):
        """The lines of the question."""
        raise NotImplementedError

    def compare(self, run, factor):
        """The answer of a run, which carries the loads with the factor."""
        raise NotImplementedError

    def judge_refusal(self, run):
        """A run without an answer."""
        self.report("fault" if run.status == COLLAPSE else "undecided", run,
                    f"{run.verdict()}: {run.message}")

    def agree(self, run, what, value, between, scale):
        """Compare a greatest value with the numbers that it is between."""
        if numpy.isnan(between.most):
            self.report("doubtful", run, f"{what}: HiGHS has no answer, and "
                        f"{value!r} is said")
            return
        room = self.largest_difference * max(
            scale, abs(value) if numpy.isfinite(value) else 0.)
        away = between.away(value)
        if away > room:
            self.report("fault", run, f"{what} is {value!r}, expected "
                        f"{between.least!r} to {between.most!r}")
        elif not between.is_known(100. * room):
            self.report("doubtful", run, f"{what} is {value!r}, and HiGHS has "
                        f"{between.least!r} to {between.most!r}")
        self.difference = max(self.difference,
                              away / scale if numpy.isfinite(away) else 0.)
