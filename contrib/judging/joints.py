"""The joints of a packing, as interfaces.csv has them, and what they admit.

Forces x go joint by joint: the pressures p_k >= 0 at the contacts, then the
tangential force q. A joint has one contact, in its middle, or one at each end
where blocks turn. Signs are those of doc/notation.md.
"""
import dataclasses

import numpy
import scipy.sparse


class Joints:
    """The joints of a run of the program, from the rows of interfaces.csv."""

    def __init__(self, rows, rotations):
        def column(name):
            return numpy.array([float(row[name]) for row in rows])

        def columns(*names):
            return numpy.stack([column(name) for name in names], 1)

        self.rotations = rotations
        self.cells = columns("cell_minus", "cell_plus").astype(int)
        self.start, self.end = columns("x0", "y0"), columns("x1", "y1")
        self.normal = columns("nx", "ny")
        self.tangent = self.normal[:, ::-1] * (-1., 1.)
        self.length = column("length")
        self.strength = column("strength")
        self.coefficient = column("coefficient") if "coefficient" in rows[0] \
            else numpy.zeros(len(rows))
        self.n_contacts = 2 if rotations else 1
        # The largest tension and compression.
        self.tension = self.length * column("tensile_strength") \
            if "tensile_strength" in rows[0] else numpy.zeros(len(rows))
        self.crushing = self.length * column("compressive_strength") \
            if "compressive_strength" in rows[0] \
            else numpy.full(len(rows), numpy.inf)

    def __len__(self):
        return len(self.length)

    def contacts(self):
        """The points at which the pressures act, contact by contact."""
        if self.rotations:
            return [self.start, self.end]
        return [0.5 * (self.start + self.end)]

    def in_order(self, pressures, tangential):
        """One vector, of the numbers of contacts and those of friction."""
        return numpy.stack([*pressures, tangential], 1).ravel()

    def equilibrium(self, centre, unit_of_length):
        """The matrix of the sums of forces on the cells, cell by cell.

        Where blocks turn each third row is a torque, over the unit of length.
        """
        n_forces = self.n_contacts + 1
        n_rows = 3 if self.rotations else 2
        directions = [-self.normal] * self.n_contacts + [self.tangent]
        points = self.contacts() + [self.start]
        rows, columns, values = [], [], []
        for side, sign in enumerate((1., -1.)):
            there = numpy.nonzero(self.cells[:, side] >= 0)[0]
            cell = self.cells[there, side]
            for i, (direction, point) in enumerate(zip(directions, points)):
                force = sign * direction[there]
                arm = (point[there] - centre[cell]) / unit_of_length
                torque = arm[:, 0] * force[:, 1] - arm[:, 1] * force[:, 0]
                for k, value in enumerate((*force.T, torque)[:n_rows]):
                    rows.append(n_rows * cell + k)
                    columns.append(n_forces * there + i)
                    values.append(value)
        return scipy.sparse.coo_matrix(
            (numpy.concatenate(values),
             (numpy.concatenate(rows), numpy.concatenate(columns))),
            (n_rows * len(centre), n_forces * len(self))).tocsr()


@dataclasses.dataclass
class AdmissibleSet:
    """The forces x with lower <= x <= upper and rows x <= limits."""
    lower: numpy.ndarray
    upper: numpy.ndarray
    rows: scipy.sparse.csr_matrix
    limits: numpy.ndarray

    def times(self, factor):
        """The forces x of which x over a positive factor is admissible.

        With zero these are the directions in which forces may grow.
        """
        def scaled(bounds):
            finite = numpy.isfinite(bounds)
            return numpy.where(finite, numpy.where(finite, bounds, 0.) * factor,
                               bounds)
        return AdmissibleSet(scaled(self.lower), scaled(self.upper), self.rows,
                             self.limits * factor)

    def no_more_than(self, size):
        """Those of these forces that are no larger than a number."""
        return AdmissibleSet(numpy.maximum(self.lower, -size),
                             numpy.minimum(self.upper, size), self.rows,
                             self.limits)

    def within(self, rows, limits):
        """Those of these forces with rows x <= limits besides."""
        return AdmissibleSet(self.lower, self.upper,
                             scipy.sparse.vstack([self.rows, rows]).tocsr(),
                             numpy.concatenate([self.limits, limits]))

    def violation(self, x):
        """By how much forces are outside, at most."""
        return max(0., numpy.max(self.lower - x), numpy.max(x - self.upper),
                   numpy.max(self.rows @ x - self.limits, initial=0.))


def admissible_set(joints):
    """|q| <= s |e| + mu p with the strength or cohesion s, and p between the
    tensile and the compressive strength; of sections no more than that.
    """
    most = joints.strength * joints.length
    coulomb = numpy.nonzero(joints.coefficient > 0.)[0]
    largest = numpy.where(joints.coefficient > 0., numpy.inf, most)
    n = joints.n_contacts
    return AdmissibleSet(
        lower=joints.in_order([-joints.tension / n] * n, -largest),
        upper=joints.in_order([joints.crushing / n] * n, largest),
        rows=scipy.sparse.vstack([friction_rows(joints, coulomb, sign)
                                  for sign in (1., -1.)]).tocsr(),
        limits=numpy.tile(most[coulomb], 2))


def friction_rows(joints, which, sign):
    """The rows sign q - mu (sum of p_k) of some joints."""
    n_forces = joints.n_contacts + 1
    rows = numpy.arange(len(which))
    columns = n_forces * which
    entries = [(rows, columns + k, -joints.coefficient[which])
               for k in range(joints.n_contacts)]
    entries.append((rows, columns + joints.n_contacts,
                    numpy.full(len(which), sign)))
    row, column, value = (numpy.concatenate(part) for part in zip(*entries))
    return scipy.sparse.coo_matrix(
        (value, (row, column)), (len(which), n_forces * len(joints)))


def resistance(joints, sections, opening, sliding):
    """What joints dissipate in a motion, and by how much they close.

    The largest work of admissible forces, opening being contact by contact:
    it is finite where p_k opens by at least mu times the sliding, or crushes.
    """
    n = joints.n_contacts
    closing = joints.coefficient * numpy.abs(sliding) - opening
    dissipation = (joints.strength * joints.length -
                   joints.coefficient * joints.tension) * numpy.abs(sliding)
    dissipation += (joints.tension / n * opening).sum(0)
    crushes = numpy.isfinite(joints.crushing)
    if joints.rotations:
        dissipation[sections.which] += sections.resistance(-closing)
    else:
        dissipation[crushes] += ((joints.crushing + joints.tension)[crushes] *
                                 numpy.maximum(closing[0, crushes], 0.))
    return dissipation.sum(), numpy.max(closing[:, ~crushes], initial=0.)
