"""The greatest value of a function of the forces among all states, by HiGHS."""
import dataclasses

import numpy

from judging.programme import CLEAR, error_of, minimise
from judging.sections import Strips

# HiGHS's words for an optimum and for none.
OPTIMAL, UNBOUNDED = 0, 3
METHODS = ("highs", "highs-ds", "highs-ipm")
# By how much forces may be outside of a section, over the largest load.
TOLERANCE = 1e-10
MOST_ROUNDS = 20
# More than any force that has a limit, over the largest load.
ALL_FORCES = 1e5


@dataclasses.dataclass
class Extreme:
    """A greatest value, and what errors of HiGHS may do to it.

    Infinite if there is none, not a number if HiGHS has no answer.
    """
    value: float
    error: float = 0.


class Extremes:
    """Of the dead loads of a programme."""

    def __init__(self, programme):
        self.programme = programme
        self.force = numpy.abs(programme.dead).max(initial=0.) or 1.
        self.strips = Strips(programme.sections, programme.admissible_ends)
        self.matrix_of_strips = programme.matrix @ self.strips.matrix
        self.loads_of_strips = programme.dead + \
            programme.matrix @ self.strips.offset

    def optimum(self, function, matrix, loads, limits, method):
        """One programme: the value, and HiGHS's forces if there are any."""
        found = minimise(-function, matrix, -loads / self.force,
                         limits.times(1. / self.force), method, [])
        if found.status == UNBOUNDED and self.has_ray(function, matrix, limits):
            return Extreme(numpy.inf), None
        if found.status == UNBOUNDED:
            # Not so, as HiGHS says now and then where there are no loads.
            found = minimise(-function, matrix, -loads / self.force,
                             limits.times(1. / self.force).no_more_than(
                                 ALL_FORCES), method, [])
        if found.status != OPTIMAL:
            return Extreme(numpy.nan), None
        return Extreme(-found.fun * self.force,
                       error_of(found) * self.force), found.x * self.force

    def has_ray(self, function, matrix, limits):
        """Whether forces that may grow for ever balance, and have more of a
        function the more they grow."""
        found = minimise(-function, matrix, numpy.zeros(matrix.shape[0]),
                         limits.times(0.).no_more_than(1.), METHODS[0], [])
        return found.status != OPTIMAL or -found.fun > CLEAR

    def greatest(self, function, method="highs"):
        """The greatest value with sections in strips."""
        extreme, _ = self.optimum(
            self.strips.matrix.T @ function, self.matrix_of_strips,
            self.loads_of_strips, self.strips.admissible, method)
        extreme.value += function @ self.strips.offset
        return extreme

    def most(self, function, enough):
        """A value that is not less than the greatest, and is that if it is more
        than a number that is enough."""
        for _ in range(MOST_ROUNDS):
            extreme, forces = self.optimum(
                function, self.programme.matrix, self.programme.dead,
                self.programme.admissible, METHODS[0])
            if not extreme.value > enough or forces is None or \
                    not self.programme.cut(forces, TOLERANCE * self.force):
                return extreme
        return Extreme(numpy.nan)

    def difference(self, function, value):
        """Of a value from the greatest one, over the largest load, by that of
        HiGHS's methods which comes closest; None if none has an answer."""
        def away(extreme):
            if extreme.value == value:
                return 0.
            by = (abs(extreme.value - value) - 2. * extreme.error) / self.force
            return numpy.inf if numpy.isnan(by) else max(by, 0.)
        extremes = [self.greatest(function, METHODS[0])]
        if not away(extremes[0]) < TOLERANCE:
            extremes += [self.greatest(function, method)
                         for method in METHODS[1:]]
        known = [away(extreme) for extreme in extremes
                 if not numpy.isnan(extreme.value)]
        return min(known) if known else None

    def excess(self, function, bound, tolerance):
        """By how much the greatest value is more than a bound, over the largest
        load, if by more than a tolerance; None if HiGHS has no answer."""
        extreme = self.most(function, bound + tolerance * self.force)
        if numpy.isnan(extreme.value):
            return None
        return max(0., extreme.value - bound - 2. * extreme.error) / self.force
