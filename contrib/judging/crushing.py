"""The judgement of one scene whose joints crush between blocks that turn: its
factors with states beside them, ranges, or settlements, with whole sections.

HiGHS has polygons around the sections and others within them, which get more
sides where forces are until both have the same value: a proof from both sides.
"""
import numpy

from judging.extremes import METHODS, OPTIMAL, Extreme, Extremes
from judging.factors import FactorJudgement
from judging.packing import number
from judging.programme import NONE, IntervalProgramme, error_of, minimise
from judging.ranges import RangeJudgement
from judging.scenes import SmallScene, draw_loads
from judging.sections import ENDS
from judging.settlements import SettlementJudgement

# Of ends of ranges and of works, over the largest load, and of couples about
# the ends of places.
LARGEST_DIFFERENCE, LINEAR = 1e-6, 1e-8
# By how much forces may be outside of a section, over the largest load.
TOLERANCE = 1e-10
# Of the values with both polygons, which stop to be refined then.
SMALLEST_GAP = 1e-9
MOST_ROUNDS = 25
# Of corners from each other, and of forces from a chord, over the strength: as
# far from the curve as the square of that over eight.
LEAST_SIDE, CLOSE = 1e-5, 1e-9


class CrushingScene(SmallScene):
    """A small scene in which all joints crush and some bear tension."""
    share_floating = 0.15

    def __init__(self, seed, k):
        super().__init__(seed, k)
        self.rotations = True
        self.question = k % 3

    def contact_entries(self):
        lines = [line for line in super().contact_entries()
                 if "Compressive" not in line]
        return [*lines, "set Compressive strength = " +
                number(10. ** self.choice.uniform(-0.3, 2.))]

    def draw_loads(self, packing):
        return draw_loads(self, packing)


class CrushingProgramme(IntervalProgramme):
    """Load factors with whole sections, between polygons around and within."""

    def __init__(self, *scene):
        super().__init__(*scene)
        # The corners within, over the strengths.
        self.corners = [ENDS] * len(self.sections)

    def within(self):
        """The forces in the polygons within the sections."""
        section = numpy.repeat(numpy.arange(len(self.corners)),
                               [len(at) - 1 for at in self.corners])
        start, end = (numpy.concatenate([at[part] for at in self.corners])
                      for part in (slice(-1), slice(1, None)))
        strength = self.sections.strength[section]
        return self.admissible_ends.within(*self.sections.secants(
            section, start * strength, end * strength))

    def minimise(self, cost, matrix, right, force, method, further_bounds,
                 share=1.):
        """The least value with the polygons within, and as what is outside of
        it the most by which that of whole sections may be less."""
        if not self.sections:
            return super().minimise(cost, matrix, right, force, method,
                                    further_bounds, share)

        def solve(admissible):
            return minimise(cost, matrix, right / force,
                            admissible.times(share / force), method,
                            further_bounds)
        for _ in range(MOST_ROUNDS):
            around, within = solve(self.admissible), solve(self.within())
            if around.status != 0:
                return around
            gap = within.fun - around.fun if within.status == 0 else numpy.inf
            if gap <= SMALLEST_GAP * max(1., abs(around.fun)):
                break
            self.refine(*(found.x[:self.matrix.shape[1]] * force
                          for found in (around, within) if found.status == 0),
                        force)
        if within.status == 0:
            within["outside"] = max(gap, 0.)
        return within

    def refine(self, around, *others):
        """Corners where forces around are, and beside those of forces within,
        and tangents at the former."""
        *within, force = others
        self.cut(around, TOLERANCE * force)
        strength = self.sections.strength
        share = numpy.clip(
            self.sections.pressures(around).sum(0) / strength, 0., 1.)
        for k, at in enumerate(self.corners):
            self.corners[k] = inserted(at, share[k])
        for x in within:
            p = self.sections.pressures(x)
            share = numpy.clip(p.sum(0) / strength, 0., 1.)
            for k, at in enumerate(self.corners):
                chord = max((at[1:] + at[:-1]) * share[k] - at[1:] * at[:-1])
                if p[:, k].min() > (0.5 * chord + CLOSE) * strength[k]:
                    continue
                # The side that it is on, and both beside.
                side = numpy.searchsorted(at, share[k])
                beside = at[max(side - 2, 0):side + 2]
                for there in (share[k], *(0.5 * (beside[1:] + beside[:-1]))):
                    self.corners[k] = inserted(self.corners[k], there)


def inserted(corners, at):
    """The corners with one more, unless it is all but there."""
    if numpy.abs(corners - at).min() < LEAST_SIDE:
        return corners
    return numpy.sort(numpy.append(corners, at))


class WholeSections(Extremes):
    """Greatest values with whole sections."""

    def greatest(self, function, method=METHODS[0]):
        programme = self.programme
        found = programme.minimise(-function, programme.matrix,
                                   -programme.dead, self.force, method, [])
        if found.status != OPTIMAL or \
                error_of(found) > LARGEST_DIFFERENCE * max(1., abs(found.fun)):
            return Extreme(numpy.nan)
        return Extreme(-found.fun * self.force,
                       error_of(found) * self.force)


class CrushingFactors(FactorJudgement):
    """Both ends of the factors that are carried, and states beside them."""
    scenes = CrushingScene
    programme_of = CrushingProgramme

    def state_run(self, factor, way="least energy"):
        return super().state_run(factor, way)


class _Whole:
    """What is asked of all states, with whole sections if there are any."""
    programme_of = CrushingProgramme

    @staticmethod
    def extremes_of(programme):
        """The greatest values of a programme."""
        return (WholeSections if programme.sections else Extremes)(programme)

    @property
    def largest_difference(self):
        """Of ends and of couples, over the largest load."""
        return LARGEST_DIFFERENCE if self.programme.sections else LINEAR

    largest_couple = largest_difference

    def judge_refusal(self, run):
        """A fault where the loads are carried."""
        if "cannot follow" not in run.message and \
                self.programme.shortage(self.programme.dead) < NONE:
            self.report("fault", run, f"{run.verdict()}, expected carried; "
                        f"{run.message}")
        else:
            super().judge_refusal(run)


class WholeRanges(_Whole, RangeJudgement):
    """The least and the greatest value of forces."""


class WholeSettlement(_Whole, SettlementJudgement):
    """The work of supports that move."""


class CrushingRanges(WholeRanges):
    """That of scenes that crush."""
    scenes = CrushingScene


class CrushingSettlement(WholeSettlement):
    """That of scenes that crush."""
    scenes = CrushingScene


def crushing_judgement(program, scene, report):
    """That of the question of a scene."""
    judgement = (CrushingFactors, CrushingRanges,
                 CrushingSettlement)[scene.question]
    if judgement is CrushingSettlement and scene.is_floating:
        judgement = CrushingRanges
    return judgement(program, scene, report)


crushing_judgement.scenes = CrushingScene
