"""The greatest value of a function of the forces among all states in space.

HiGHS has two linear programmes, with polygons around the discs that limit
friction and with polygons within them. Both get sides where forces are, until
their values are the same: a proof from both sides.
"""
import dataclasses

import numpy
import scipy.optimize
import scipy.sparse

from judging.programme import CLEAR, NONE, error_of

# The angles of the first sides, of which there are eight.
FIRST = 2. * numpy.pi * numpy.arange(8) / 8.
# Of forces from a disc, and of the values with both polygons, over the force of
# reference; and of corners from each other.
CLOSE, SMALLEST_GAP, LEAST_ANGLE = 1e-8, 3e-8, 1e-5
# The last rounds have polygons within in any case.
MOST_ROUNDS, LAST_ROUNDS = 20, 3
OPTIMAL = 0
OPTIONS = {"primal_feasibility_tolerance": 1e-10,
           "dual_feasibility_tolerance": 1e-10, "time_limit": 10.}


@dataclasses.dataclass
class Between:
    """Two numbers between which a greatest value is; both are infinite where
    there is none, and no numbers where HiGHS has no answer."""
    least: float
    most: float

    def away(self, value):
        """By how much a value is outside."""
        if self.least == value or self.most == value:
            return 0.
        return max(self.least - value, value - self.most, 0.)

    def is_known(self, gap):
        """Whether both are the same within a gap."""
        return self.least == self.most or self.most - self.least <= gap


UNKNOWN = Between(numpy.nan, numpy.nan)


class SpaceExtremes:
    """Of the states of a PolygonProgramme that carry loads."""

    def __init__(self, programme, loads):
        self.programme = programme
        blocks = programme.blocks
        self.matrix = scipy.sparse.csc_matrix(numpy.stack(
            [programme.reduced(column) for column in programme.columns],
            axis=1))
        self.right = -programme.reduced(loads + programme.offset)
        self.force = numpy.abs(loads).max(initial=0.) or 1.
        normal = blocks.normal[blocks.joint]
        size = blocks.share * blocks.area[blocks.joint] * blocks.presses
        # The forces of joints without pressure, which tension moves.
        self.offset = (programme.scene.tension * size)[:, None] * normal
        self.limits = numpy.array(programme.limits).reshape(-1, 4)
        self.at = self.limits[:, 0].astype(int)
        self.pressure = self.limits[:, 1].astype(int)

    def greatest(self, vectors):
        """Of the sum of the forces on c- at the points times vectors."""
        cost = -(vectors[self.programme.places] *
                 numpy.array(self.programme.directions)).sum(axis=1)
        angles = [FIRST] * len(self.limits)
        found = self.search(cost, angles)
        if numpy.isnan(found.most):
            ray = self.search(cost, angles, is_ray=True)
            if ray.least > CLEAR:
                return Between(numpy.inf, numpy.inf)
            if not ray.most < NONE:
                return UNKNOWN
            found = self.search(cost, angles)
        constant = (vectors * self.offset).sum()
        return Between(found.least * self.force + constant,
                       found.most * self.force + constant)

    def search(self, cost, angles, is_ray=False):
        """Programmes with more and more sides; changes the angles.

        A ray is a state without loads and strengths, of forces up to one."""
        between, before = UNKNOWN, numpy.inf
        for k in range(MOST_ROUNDS):
            around = self.solve(cost, angles, False, is_ray)
            if around.status != OPTIMAL:
                return between
            most = -around.fun + error_of(around)
            room = SMALLEST_GAP * max(1., abs(most))
            if is_ray and most < NONE:
                return Between(-numpy.inf, most)
            self.refine(angles, around.x, is_ray)
            between = Between(-numpy.inf, most)
            if before - most > room and k < MOST_ROUNDS - LAST_ROUNDS:
                before = most
                continue
            before = most
            within = self.solve(cost, angles, True, is_ray)
            if within.status != OPTIMAL:
                continue
            between = Between(-within.fun - error_of(within), most)
            if between.is_known(room) or (is_ray and between.least > CLEAR):
                break
            self.refine_beside(angles, within.x)
        return between

    def caps(self, x, is_ray):
        """The limits of friction with some forces."""
        mu, cap = self.limits[:, 2], self.limits[:, 3] / self.force
        p = numpy.where(self.pressure >= 0, x[self.pressure], 0.)
        return mu * p + (0. if is_ray else cap)

    def refine(self, angles, x, is_ray):
        """A side more where forces are beyond a disc."""
        q = numpy.hypot(x[self.at], x[self.at + 1])
        beyond = q - self.caps(x, is_ray) > CLOSE * max(1., abs(x).max())
        for k in numpy.nonzero(beyond)[0]:
            at = self.at[k]
            insert(angles, k, numpy.arctan2(x[at + 1], x[at]))

    def refine_beside(self, angles, x):
        """A corner more where forces are, and two beside."""
        for k, at in enumerate(self.at):
            if not numpy.hypot(x[at], x[at + 1]) > 0.:
                continue
            angle = numpy.arctan2(x[at + 1], x[at]) % (2. * numpy.pi)
            after = numpy.searchsorted(angles[k], angle)
            around = numpy.append(angles[k], angles[k][0] + 2. * numpy.pi)
            low = around[after - 1] if after > 0 else \
                angles[k][-1] - 2. * numpy.pi
            for there in (angle, 0.5 * (low + around[after])):
                insert(angles, k, there)

    def solve(self, cost, angles, is_within, is_ray):
        """One programme, over the force of reference."""
        rows, cols, values, most = [], [], [], []
        for k, (at, pressure, mu, cap) in enumerate(self.limits):
            of = angles[k]
            radius = 1.
            if is_within:
                # The middles of the sides between the corners.
                width = 0.5 * (numpy.append(of[1:], of[0] + 2. * numpy.pi) - of)
                of, radius = of + width, numpy.cos(width)
            n = len(of)
            row = len(most) + numpy.arange(n)
            rows += [row, row]
            cols += [numpy.full(n, int(at)), numpy.full(n, int(at) + 1)]
            values += [numpy.cos(of), numpy.sin(of)]
            if pressure >= 0:
                rows.append(row)
                cols.append(numpy.full(n, int(pressure)))
                values.append(-mu * radius * numpy.ones(n))
            cap = 0. if is_ray else cap / self.force
            most += list(cap * radius * numpy.ones(n))
        upper = 1. if is_ray else numpy.inf
        bounds = numpy.array([(-upper if low < 0. else 0., upper)
                              for low in self.programme.signs])
        sides = scipy.sparse.csc_matrix(
            (numpy.concatenate(values),
             (numpy.concatenate(rows), numpy.concatenate(cols))),
            (len(most), len(cost))) if most else None
        return scipy.optimize.linprog(
            cost, A_ub=sides, b_ub=most or None, A_eq=self.matrix,
            b_eq=self.right / self.force * (0. if is_ray else 1.),
            bounds=bounds, method="highs", options=OPTIONS)


def insert(angles, k, angle):
    """One angle more of one disc, unless it is all but there."""
    angle %= 2. * numpy.pi
    away = numpy.abs(angles[k] - angle)
    if numpy.minimum(away, 2. * numpy.pi - away).min() > LEAST_ANGLE:
        angles[k] = numpy.sort(numpy.append(angles[k], angle))
