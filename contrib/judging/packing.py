"""Cells as the program writes them, and the loads on them.

Loads are added up here once more, from the polygons of packing.wkt and the
joints, so that a wrong load of the program is seen.
"""
import dataclasses
import re

import numpy


class Packing:
    """The cells of a run: polygons, areas, centroids, centres, free edges."""

    def __init__(self, wkt, rows, joints):
        self.polygons = [polygon_of(line) for line in wkt.splitlines()
                         if line.startswith("POLYGON")]
        self.centre = numpy.array([[float(row["x"]), float(row["y"])]
                                   for row in rows])
        self.written_area = numpy.array([float(row["area"]) for row in rows])
        self.area, self.centroid = zip(*map(moments_of, self.polygons))
        self.area, self.centroid = map(numpy.array, (self.area, self.centroid))
        self.size = numpy.sqrt(self.area.mean())
        self.free_edges = self.edges_without(joints)

    def __len__(self):
        return len(self.polygons)

    def edges_without(self, joints):
        """The free edges: cell, both ends in order, outward normal."""
        taken = {}
        for cells, start, end in zip(joints.cells, joints.start, joints.end):
            for cell in cells:
                taken.setdefault(cell, []).append(0.5 * (start + end))
        edges = []
        for cell, polygon in enumerate(self.polygons):
            middles = numpy.array(taken.get(cell, [])).reshape(-1, 2)
            for a, b in zip(polygon, numpy.roll(polygon, -1, 0)):
                away = numpy.abs(middles - 0.5 * (a + b)).max(1, initial=0.)
                if not numpy.any(away < 1e-9 * self.size):
                    side = b - a
                    normal = numpy.array((side[1], -side[0]))
                    edges.append((cell, a, b, normal / numpy.hypot(*side)))
        return edges


def polygon_of(line):
    """The vertices of a POLYGON, counterclockwise and each once."""
    ring = re.search(r"\(\(([^)]*)\)", line).group(1)
    points = numpy.array([[float(x) for x in point.split()]
                          for point in ring.split(",")])[:-1]
    return points if moments_of(points)[0] > 0. else points[::-1]


def moments_of(polygon):
    """The area, negative if clockwise, and the centroid."""
    origin = polygon.mean(0)
    a = polygon - origin
    b = numpy.roll(a, -1, 0)
    twice = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return 0.5 * twice.sum(), origin + (twice[:, None] * (a + b)).sum(0) / (
        3. * twice.sum())


# Directions of free edges that a traction acts on: an expression for the
# program, and the same for this one.
SIDES = {"ny > 0.4873": lambda n: n[1] > 0.4873,
         "nx > 0.4873": lambda n: n[0] > 0.4873,
         "nx < -0.4873": lambda n: n[0] < -0.4873,
         "abs(nx) > 0.4873": lambda n: abs(n[0]) > 0.4873}


@dataclasses.dataclass
class Loads:
    """A body force, a stress on the free boundary, tractions on sides of it,
    and forces on cells; all of them constant."""
    body: numpy.ndarray = dataclasses.field(
        default_factory=lambda: numpy.zeros(2))
    stress: numpy.ndarray = dataclasses.field(
        default_factory=lambda: numpy.zeros((2, 2)))
    # The traction by the expression of a side.
    tractions: dict = dataclasses.field(default_factory=dict)
    # The force by cell, each at the centroid.
    forces: dict = dataclasses.field(default_factory=dict)

    def plus(self, factor, other):
        """These loads and a factor times others."""
        def sums(mine, theirs):
            none = numpy.zeros(2)
            return {key: mine.get(key, none) + factor * theirs.get(key, none)
                    for key in sorted({*mine, *theirs})}
        return Loads(self.body + factor * other.body,
                     self.stress + factor * other.stress,
                     sums(self.tractions, other.tractions),
                     sums(self.forces, other.forces))

    def turned(self, rotation):
        """These loads, which have no sides, after a rotation."""
        stress = rotation @ self.stress @ rotation.T
        return Loads(rotation @ self.body, 0.5 * (stress + stress.T),
                     forces={cell: rotation @ force
                             for cell, force in self.forces.items()})

    def entries(self):
        """The entries of a section of a .prm file."""
        lines = [f"set Body force = {number(self.body[0])}; "
                 f"{number(self.body[1])}"]
        if self.tractions:
            lines.append("set Traction = " +
                         "; ".join(map(self.traction, (0, 1))))
        else:
            (xx, xy), (yx, yy) = self.stress
            lines += ["set Boundary load = uniform stress",
                      f"set Stress = {number(xx)}, {number(xy)}; "
                      f"{number(yx)}, {number(yy)}"]
        if self.forces:
            lines.append("set Cell forces = " + "; ".join(
                f"cell {cell}: {number(x)}, {number(y)}"
                for cell, (x, y) in self.forces.items()))
        return lines

    def traction(self, i):
        """The expression of one component of all tractions."""
        terms = [f"({number(self.stress[i, 0])})*nx",
                 f"({number(self.stress[i, 1])})*ny"]
        terms += [f"({side} ? {number(force[i])} : 0)"
                  for side, force in self.tractions.items()]
        return " + ".join(terms)

    def on(self, packing):
        """The force and the torque about the centre of each cell."""
        loads = numpy.zeros((len(packing), 3))

        def add(cell, force, point):
            arm = point - packing.centre[cell]
            loads[cell] += (*force, arm[0] * force[1] - arm[1] * force[0])

        for cell in range(len(packing)):
            add(cell, packing.area[cell] * self.body, packing.centroid[cell])
        for cell, force in self.forces.items():
            add(cell, force, packing.centroid[cell])
        for cell, a, b, normal in packing.free_edges:
            traction = self.stress @ normal
            for side, force in self.tractions.items():
                if SIDES[side](normal):
                    traction = traction + force
            add(cell, numpy.hypot(*(b - a)) * traction, 0.5 * (a + b))
        return loads


def number(value):
    """All digits of a number."""
    return repr(float(value))
