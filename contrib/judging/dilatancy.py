"""Collapse by Coulomb's friction without dilatancy, by linear programmes.

Such a collapse is a pair: forces within Coulomb's cone that balance the loads at
a factor, and a motion that closes no joint, opens none that is pressed, and
slides without opening where friction is at its limit, against it. There may be
many, at many factors.

Gilbert, Casapulla and Ahmed (Computers and Structures 84 (2006), 873) find one
by programmes with Tresca's friction, whose strengths are those of the normal
forces before. Each programme has many optima. Which of them is taken decides
where the scheme goes, and that it ends at all: of all optima it is here the one
whose normal forces are closest to those before, which finds large factors, or
before that the one with the least normal forces where joints slide, which finds
small ones.
"""
import copy
import dataclasses
import time

import numpy
import scipy.sparse

from judging.joints import admissible_set
from judging.programme import minimise

# What a unit of force costs, over what a unit of the factor yields: a change of
# a normal force, and a normal force of the joint that slides most.
CHANGE, PRESSURE = 1e-7, 1e-5
# The same where no pressure counts.
CHANGE_ALONE = 1e-6
# As many programmes as have so many joints altogether, within limits. After half
# of them no pressure counts any more, so that the last ones converge.
MOST_JOINTS, PROGRAMMES = 30000, (20, 80)
# Of the factor from one programme to the next, and of friction beyond the cone
# over the largest load, where the scheme ends.
SMALLEST_STEP, SMALLEST_EXCESS = 1e-8, 1e-7
# Of the factors with the costs and without that are the same.
SAME = 1e-6
# The step to the next normal forces, over their change: at first, the least and
# the largest.
STEP, LEAST_STEP, LARGEST_STEP = 0.5, 0.2, 4.


@dataclasses.dataclass
class Pair:
    """Forces and a motion, joint by joint, and what they leave wrong."""
    factor: float
    forces: numpy.ndarray
    # Opening at both ends and sliding, for live loads whose work is one.
    jumps: numpy.ndarray
    # Friction beyond Coulomb's cone, over the largest load.
    excess: float
    # The work of forces that no pair has, over that of friction: pressures
    # where joints open, and limits of friction that are not reached or not
    # against the sliding.
    idle_work: float
    # By how much joints close, over the largest jump.
    closing: float
    programmes: int = 0
    seconds: float = 0.

    def error(self):
        return max(self.excess, self.idle_work, self.closing)


class WithoutDilatancy:
    """The programmes of a scene."""

    def __init__(self, programme):
        self.programme = programme
        self.joints = joints = programme.joints
        self.cohesion = joints.strength * joints.length
        self.unit = programme.unit
        self.force = programme.force_at(self.unit)
        n = len(joints)
        every = numpy.arange(n)
        sums = scipy.sparse.coo_matrix(
            (numpy.ones(2 * n), (numpy.tile(every, 2), numpy.concatenate(
                [3 * every, 3 * every + 1]))), (n, 3 * n))
        live = programme.live[:, None] * (self.unit / self.force)
        one = scipy.sparse.identity(n)
        # The balance of the cells; the change of each normal force.
        self.matrix = scipy.sparse.bmat(
            [[programme.matrix, live, None, None],
             [sums, None, -one, one]]).tocsc()
        self.n_programmes = 0

    def friction(self, pressures):
        """The limits of friction."""
        return self.cohesion + \
            self.joints.coefficient * numpy.maximum(pressures, 0.)

    def solve(self, limits, before, change, pressure, slope=0.):
        """The greatest factor with the limits of friction and a slope of the
        cone, over that of the joints; None if HiGHS has none.

        The costs are those of a change of a normal force, and of each.
        """
        joints = copy.copy(self.joints)
        joints.coefficient = slope * joints.coefficient
        joints.strength = limits / joints.length
        n = len(joints)
        cost = numpy.full(self.matrix.shape[1], change)
        cost[:3 * n] = numpy.stack([pressure, pressure, 0. * pressure],
                                   1).ravel()
        cost[3 * n] = -1.
        right = numpy.concatenate([-self.programme.dead, before]) / self.force
        self.n_programmes += 1
        for method in ("highs", "highs-ipm"):
            found = minimise(cost, self.matrix, right, admissible_set(
                joints).times(1. / self.force), method,
                [(None, None), *[(0., None)] * (2 * n)])
            if found.status == 0:
                break
        else:
            return None
        motion = -found.eqlin.marginals[:len(self.programme.dead)]
        motion /= self.programme.live @ motion
        return self.pair(found.x[3 * n] * self.unit,
                         found.x[:3 * n].reshape(-1, 3) * self.force,
                         (self.programme.matrix.T @ motion).reshape(-1, 3))

    def pair(self, factor, forces, jumps):
        """What forces and a motion with live work one leave wrong."""
        opening, sliding = jumps[:, :2], jumps[:, 2]
        limit = self.friction(forces[:, :2].sum(1))
        work = limit * numpy.abs(sliding)
        idle = numpy.abs(forces[:, :2] * opening).sum() + \
            numpy.abs(work + forces[:, 2] * sliding).sum()
        excess = numpy.max(numpy.abs(forces[:, 2]) - limit) / self.force
        return Pair(factor, forces, jumps, max(0., excess),
                    idle / (work.sum() + abs(factor)),
                    max(0., -opening.min()) / numpy.abs(jumps).max())

    def associated(self):
        """The collapse with dilatancy."""
        none = numpy.zeros(len(self.joints))
        return self.solve(self.cohesion, none, 0., none, slope=1.)

    def search(self, least=False):
        """A pair, of those with small factors or of those with large ones;
        None if HiGHS has no answer."""
        began, self.n_programmes = time.monotonic(), 0
        found = self.associated()
        if found is None:
            return None
        before = found.forces[:, :2].sum(1)
        step, residual = STEP, None
        most = numpy.clip(MOST_JOINTS // len(self.joints), *PROGRAMMES)
        for k in range(most):
            last = found
            found = self.step(before, last,
                              least and 2 * k < most)
            if found is None:
                return None
            if abs(found.factor - last.factor) <= \
                    SMALLEST_STEP * abs(found.factor) and \
                    found.excess <= SMALLEST_EXCESS:
                break
            last_residual = residual
            residual = found.forces[:, :2].sum(1) - before
            if last_residual is not None:
                step = relaxed(step, last_residual, residual)
            before = numpy.maximum(before + step * residual, 0.)
        # The motion of the costs is wrong by these: that without.
        none = numpy.zeros(len(self.joints))
        alone = self.solve(self.friction(before), before, 0., none)
        if alone is not None and abs(alone.factor - found.factor) <= \
                SAME * abs(found.factor):
            found = self.pair(found.factor, found.forces, alone.jumps)
        found.programmes = self.n_programmes
        found.seconds = time.monotonic() - began
        return found

    def step(self, before, last, least):
        """The next programme."""
        change, sliding = CHANGE_ALONE, numpy.zeros(len(self.joints))
        if least:
            change = CHANGE
            sliding = self.joints.coefficient * numpy.abs(last.jumps[:, 2])
            sliding *= PRESSURE / (sliding.max() or 1.)
        return self.solve(self.friction(before), before, change, sliding)


def relaxed(step, before, after):
    """The next step of Irons and Tuck, by two changes."""
    difference = after - before
    square = difference @ difference
    if not square > 0.:
        return step
    return min(max(-step * (before @ difference) / square, LEAST_STEP),
               LARGEST_STEP)
