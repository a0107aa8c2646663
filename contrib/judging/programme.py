"""The load factor as a linear programme, by HiGHS.

Greatest or least alpha, so that A x + dead + alpha live = 0 has admissible
forces x. Unknowns have no units: lengths over the mean size of a cell, forces
over the largest of the loads at a given factor, alpha over a given unit.
"""
import dataclasses

import numpy
import scipy.optimize
import scipy.sparse

from judging.joints import admissible_set
from judging.sections import Sections

TOLERANCE = 1e-10
# A shortage of forces, over the loads: none, and one that is no rounding.
NONE, CLEAR = 1e-9, 1e-7


@dataclasses.dataclass
class Answer:
    """What HiGHS or the program says."""
    # "not carried", "bounded", "unbounded" or "doubtful"
    kind: str
    # Why it is doubtful.
    reason: str = ""
    factor: float = numpy.nan
    # What residuals of HiGHS may do to the factor.
    error: float = 0.
    # The change of the factor by imbalances of one load unit on each row.
    sensitivity: float = 0.


class Programme:
    """The scene: joints, cells, dead and live loads (cells x 3)."""

    def __init__(self, joints, packing, dead, live):
        self.joints = joints
        self.length = packing.size
        self.matrix = joints.equilibrium(packing.centre, self.length)
        self.sections = Sections(joints)
        self.admissible_ends = admissible_set(joints)
        self.admissible = self.admissible_ends.within(*self.sections.rows())
        self.dead, self.live = self.rows_of(dead), self.rows_of(live)
        crushing = numpy.where(numpy.isfinite(joints.crushing),
                               joints.crushing, 0.)
        friction = max(numpy.max(bound, initial=0.) for bound in (
            joints.strength * joints.length, joints.tension, crushing))
        dead_size = numpy.abs(self.dead).max(initial=0.)
        self.live_size = numpy.abs(self.live).max(initial=0.)
        # The factor at which live loads are as large as dead loads, or as
        # friction without these.
        self.unit = (dead_size or friction or self.live_size) / self.live_size

    def rows_of(self, loads):
        """The loads in the order of the rows of the matrix."""
        if not self.joints.rotations:
            return loads[:, :2].ravel()
        return (loads / (1., 1., self.length)).ravel()

    # The largest load that is not one of the cells'.
    further_load = 0.

    def further_forces(self, _run):
        """What a run has written of forces that are not of joints."""
        return numpy.zeros(0)

    def further_resistance(self, _jumps):
        """The most that these take out of a motion."""
        return 0.

    def violation(self, x):
        """By how much forces are not admissible, at most."""
        of_joints = x[:len(self.joints) * (self.joints.n_contacts + 1)]
        return max(self.admissible.violation(x),
                   self.sections.excess(of_joints))

    def cut(self, x, tolerance):
        """Cut off forces that no section admits; whether there are any."""
        if not self.sections.cut(x, tolerance):
            return False
        self.admissible = self.admissible_ends.within(*self.sections.rows())
        return True

    def at(self, factor):
        return self.dead + factor * self.live

    def force_at(self, factor):
        """The largest load."""
        return max(numpy.abs(self.dead).max(initial=0.),
                   abs(factor) * self.live_size)

    def shortage(self, loads, share=1.):
        """How much of these loads, over the largest, is not carried at best.

        The sum over all rows. The share is that of the limits that are not
        zero: with 0 only what grows with the loads is asked.
        """
        force = numpy.abs(loads).max()
        if not force > 0.:
            return 0.
        rows = len(loads)
        identity = scipy.sparse.identity(rows)
        matrix = scipy.sparse.hstack([self.matrix, identity, -identity])
        cost = numpy.concatenate([numpy.zeros(self.matrix.shape[1]),
                                  numpy.ones(2 * rows)])
        found = self.minimise(cost, matrix, -loads, force, "highs",
                              [(0., None)] * (2 * rows), share)
        return found.fun if found.status == 0 else numpy.nan

    def minimise(self, cost, matrix, right, force, method, further_bounds,
                 share=1.):
        """A programme whose first unknowns are the forces over a force."""
        return minimise(cost, matrix, right / force,
                        self.admissible.times(share / force), method,
                        further_bounds)

    def lacking(self):
        """How much of the dead loads is not carried, over the largest."""
        return self.shortage(self.dead)

    def optimum(self, sense, around, unit, method="highs"):
        """The factor farthest in a sense, 1 or -1, in units for a factor."""
        force = self.force_at(around)
        matrix = scipy.sparse.hstack(
            [self.matrix, self.live[:, None] * (unit / force)])
        cost = numpy.zeros(matrix.shape[1])
        cost[-1] = -sense
        found = self.minimise(cost, matrix, -self.dead, force, method,
                              [(None, None)])
        if found.status == 3:
            return Answer("unbounded")
        if found.status != 0:
            return Answer("doubtful", found.message)
        factor = found.x[-1] * unit
        return Answer("bounded", "", factor, error_of(found) * unit,
                      numpy.abs(found.eqlin.marginals).sum() * unit / force)

    def judge(self, sense, method="highs"):
        """The class and the factor."""
        shortage = self.lacking()
        if not shortage < NONE:
            return Answer("not carried") if shortage > CLEAR else Answer(
                "doubtful", f"the dead loads lack {shortage:.1e}")
        shortage = self.shortage(sense * self.live, share=0.)
        if not shortage > CLEAR:
            return Answer("unbounded") if shortage < NONE else Answer(
                "doubtful", f"unbounded live loads lack {shortage:.1e}")
        rough = self.optimum(sense, self.unit, self.unit, method)
        if rough.kind != "bounded":
            return Answer("doubtful", f"HiGHS: {rough.kind} {rough.reason}")
        size = self.scale_of(rough.factor)
        answer = self.optimum(sense, size, size, method)
        if answer.error > CLEAR * size:
            return Answer("doubtful", f"HiGHS's error is {answer.error:.1e}")
        return answer

    def scale_of(self, factor):
        """What distances from a factor are relative to."""
        if abs(factor) > 1e-3 * self.unit:
            return abs(factor)
        return self.unit


class IntervalProgramme(Programme):
    """The same where zero need not be among the factors that are carried."""

    def lacking(self):
        """How much of the loads is not carried at the best of all factors."""
        force = self.force_at(self.unit)
        rows = len(self.dead)
        identity = scipy.sparse.identity(rows)
        matrix = scipy.sparse.hstack(
            [self.matrix, identity, -identity,
             self.live[:, None] * (self.unit / force)])
        cost = numpy.zeros(matrix.shape[1])
        cost[self.matrix.shape[1]:-1] = 1.
        found = self.minimise(cost, matrix, -self.dead, force, "highs",
                              [*[(0., None)] * (2 * rows), (None, None)])
        return found.fun if found.status == 0 else numpy.nan


def minimise(cost, matrix, right, limits, method, further_bounds):
    """The linear programme, with bounds of unknowns that follow the forces."""
    n_further = len(further_bounds)
    rows = scipy.sparse.hstack(
        [limits.rows, scipy.sparse.coo_matrix((limits.rows.shape[0],
                                               n_further))])
    options = {"primal_feasibility_tolerance": TOLERANCE,
               "dual_feasibility_tolerance": TOLERANCE}
    if method == "highs-ipm":
        options["ipm_optimality_tolerance"] = 1e-12
    return scipy.optimize.linprog(
        cost, A_eq=matrix.tocsc(), b_eq=right, method=method, options=options,
        A_ub=rows.tocsc() if rows.shape[0] else None,
        b_ub=limits.limits if rows.shape[0] else None,
        bounds=[*zip(limits.lower, limits.upper), *further_bounds])


def error_of(found):
    """What the residuals of a solution may do to its value, by its prices."""
    excess = found.get("outside", 0.)
    excess += numpy.abs(found.eqlin.residual) @ numpy.abs(found.eqlin.marginals)
    for part in (found.ineqlin, found.lower, found.upper):
        beyond = numpy.maximum(-part.residual, 0.)
        excess += beyond @ numpy.abs(part.marginals)
    return excess
