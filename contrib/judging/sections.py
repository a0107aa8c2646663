"""Joints that crush between blocks that turn: rigid-plastic sections.

With p_k the pressure at an end and half of the largest tension, N = p_0 + p_1
and S the sum of the largest tension and compression, a section admits

    N^2 <= 2 S p_k,  k = 0, 1,

the rectangular stress block, (N2) in doc/theory.md. Tangents of it, each at
some N_0,

    2 N_0 N - N_0^2 <= 2 S p_k,

are a polygon around it: what a linear programme finds with them is too much,
until tangents where its forces are leave nothing outside. Strips with a force
each in their middle are one within it.
"""
import numpy
import scipy.sparse

from judging.joints import AdmissibleSet

# The strips of a section. The tangents to begin with are at shares of S where
# strips end; the last one bounds all directions in which forces may grow.
N_STRIPS = 16
ENDS = numpy.linspace(0., 1., N_STRIPS + 1)


class Sections:
    """The sections of the joints that are such."""

    def __init__(self, joints):
        self.joints = joints
        self.which = numpy.nonzero(numpy.isfinite(joints.crushing))[0] \
            if joints.rotations else numpy.array([], int)
        self.tension = joints.tension[self.which]
        self.strength = self.tension + joints.crushing[self.which]
        # Of each tangent the number of the section and N_0.
        self.section = numpy.tile(numpy.arange(len(self)), N_STRIPS)
        self.touching = numpy.multiply.outer(ENDS[1:], self.strength).ravel()

    def __len__(self):
        return len(self.which)

    def pressures(self, x):
        """p_0 and p_1 of each section."""
        ends = x.reshape(len(self.joints), -1)[self.which, :2]
        return ends.T + 0.5 * self.tension

    def rows(self):
        """The tangents as rows on all forces, and their limits."""
        return self.secants(self.section, self.touching, self.touching)

    def secants(self, section, start, end):
        """The same of the straight lines through two points N_0 of the curve:

            (a + b) N - a b <= 2 S p_k,

        which are chords between neighbours of a polygon within the section.
        """
        strength, tension = self.strength[section], self.tension[section]
        share = 0.5 * (start + end) / strength
        n = len(section)
        rows, columns, values, limits = [], [], [], []
        for k in range(2):
            for at in range(2):
                rows.append(numpy.arange(n) + k * n)
                columns.append(3 * self.which[section] + at)
                values.append(share - (k == at))
            limits.append(0.5 * start * end / strength -
                          tension * (share - 0.5))
        row, column, value = map(numpy.concatenate, (rows, columns, values))
        return scipy.sparse.coo_matrix(
            (value, (row, column)),
            (2 * n, (self.joints.n_contacts + 1) * len(self.joints))).tocsr(), \
            numpy.concatenate(limits)

    def cut(self, x, tolerance):
        """Add tangents where forces are outside; whether there are any."""
        p = self.pressures(x)
        compression = p.sum(0)
        outside = numpy.nonzero(compression**2 / (2. * self.strength) -
                                p.min(0) > tolerance)[0]
        self.section = numpy.concatenate([self.section, outside])
        self.touching = numpy.concatenate(
            [self.touching,
             numpy.minimum(compression, self.strength)[outside]])
        return len(outside) > 0

    def excess(self, x):
        """By how much normal forces are more than the sections bear."""
        p = self.pressures(x)
        compression = p.sum(0)
        loaded = compression > 0.
        bears = 2. * self.strength[loaded] * numpy.maximum(
            p.min(0)[loaded], 0.) / compression[loaded]
        return max(numpy.max(-p.min(0), initial=0.),
                   numpy.max(compression[loaded] - bears, initial=0.))

    def resistance(self, opening):
        """The most work of each section's forces where its ends open so."""
        opening = opening[:, self.which]
        closing = -opening.mean(0)
        turning = numpy.abs(opening[0] - opening[1])
        part = numpy.where(closing > 0., 1., 0.)
        turns = turning > 0.
        part[turns] = numpy.clip(0.5 + closing[turns] / turning[turns], 0., 1.)
        return self.strength * part * (closing + 0.5 * turning * (1. - part))


class Strips:
    """Forces with those of strips y in place of the pressures of sections:
    x = matrix y + offset."""

    def __init__(self, sections, admissible):
        n, n_forces = len(sections), len(admissible.lower)
        ends = numpy.add.outer(3 * sections.which, (0, 1)).ravel()
        others = numpy.setdiff1d(numpy.arange(n_forces), ends)
        middle = 0.5 * (ENDS[:-1] + ENDS[1:])
        by_strips = scipy.sparse.kron(scipy.sparse.identity(n),
                                      numpy.array([1. - middle, middle]))
        self.matrix = scipy.sparse.hstack(
            [picked(n_forces, others),
             picked(n_forces, ends) @ by_strips]).tocsr()
        self.offset = numpy.zeros(n_forces)
        self.offset[ends] = -0.5 * numpy.repeat(sections.tension, 2)
        most = numpy.repeat(sections.strength / N_STRIPS, N_STRIPS)
        self.admissible = AdmissibleSet(
            lower=numpy.concatenate([admissible.lower[others],
                                     numpy.zeros_like(most)]),
            upper=numpy.concatenate([admissible.upper[others], most]),
            rows=(admissible.rows @ self.matrix).tocsr(),
            limits=admissible.limits - admissible.rows @ self.offset)


def picked(n, which):
    """The columns of an identity."""
    return scipy.sparse.identity(n, format="csc")[:, which]
