"""Scenes with ties, props and prestress between their blocks, and to the ground.

Each is one more unknown between two bounds: a force along a line, positive in
tension, on two cells.
"""
import numpy
import scipy.sparse

from judging.joints import AdmissibleSet
from judging.packing import number
from judging.programme import IntervalProgramme
from judging.scenes import Scene
from judging.verdicts import Judgement

MOST_TIES = 4


class TiedScene(Scene):
    """One scene; its ties are drawn when the packing is known."""
    kinds = ("Voronoi", "wall", "arch", "drawing")

    def __init__(self, seed, k):
        super().__init__(f"{seed} ties", k)
        self.name = f"ties_{seed}_{k}"
        if self.drawing:
            self.packing[2] = f"set File = {self.name}.wkt"
        self.ties = []

    def draw_ties(self, packing):
        """Between any two blocks, or from one to the ground."""
        choice = self.choice
        for _ in range(choice.randint(1, MOST_TIES)):
            a, b = choice.sample(range(-1, len(packing)), 2) if len(packing) > 1 \
                else (0, -1)
            if self.is_floating and -1 in (a, b):
                continue
            cells = max(a, b) if -1 in (a, b) else min(a, b), \
                -1 if -1 in (a, b) else max(a, b)
            places = [self.place_in(packing, cell) for cell in cells]
            size = 10. ** choice.uniform(-2., 1.)
            least, most = choice.choice(((0., 1.), (-1., 0.), (-0.4, 1.), (0.3, 1.),
                                         (0., 1e3), (0.5, 0.5)))
            self.ties.append((cells, places, size * least, size * most))

    def place_in(self, packing, cell):
        """Its centroid, a point between that and a vertex, or one beside all."""
        choice = self.choice
        if cell < 0:
            return numpy.array((choice.uniform(-1., self.width + 1.),
                                choice.uniform(-1., self.height + 1.)))
        corner = choice.choice([*packing.polygons[cell]])
        return packing.centroid[cell] + \
            choice.choice((0., 0.7)) * (corner - packing.centroid[cell])

    def text(self, settings=(), loads=None, live=None):
        lines = [super().text(settings, loads, live), "subsection Ties\n"]
        for k, (cells, places, least, most) in enumerate(self.ties):
            ends = [("ground" if cell < 0 else f"cell {cell}") +
                    f" at {number(x)}, {number(y)}"
                    for cell, (x, y) in zip(cells, places)]
            lines += [f"subsection t{k:02}\n", f"set From = {ends[0]}\n",
                      f"set To = {ends[1]}\n",
                      f"set Yield force = {number(most)}\n"]
            if least > 0.:
                lines.append(f"set Prestress = {number(least)}\n")
            elif least < 0.:
                lines.append(f"set Compressive strength = {number(-least)}\n")
            lines.append("end\n")
        return "".join(lines) + "end\n" if self.ties else lines[0]


class TiedProgramme(IntervalProgramme):
    """A programme with the forces of ties behind those of the joints."""

    def __init__(self, joints, packing, dead, live, ties):
        super().__init__(joints, packing, dead, live)
        self.ties = ties
        n_of_cell = 3 if joints.rotations else 2
        columns = numpy.zeros((len(dead) * n_of_cell, len(ties)))
        for k, (cells, places, _, _) in enumerate(ties):
            along = (places[1] - places[0]) / numpy.hypot(*(places[1] - places[0]))
            for cell, place, sign in zip(cells, places, (1., -1.)):
                if cell < 0:
                    continue
                arm = (place - packing.centre[cell]) / self.length
                column = sign * numpy.array(
                    (*along, arm[0] * along[1] - arm[1] * along[0]))
                columns[n_of_cell * cell:n_of_cell * (cell + 1), k] = \
                    column[:n_of_cell]
        self.matrix = scipy.sparse.hstack([self.matrix, columns]).tocsr()
        inner = self.admissible
        self.least, self.most = (numpy.array([tie[i] for tie in ties], float)
                                 for i in (2, 3))
        # What they have at least.
        self.further_load = numpy.abs(
            numpy.clip(0., self.least, self.most)).max(initial=0.)
        nothing = scipy.sparse.coo_matrix((inner.rows.shape[0], len(ties)))
        self.admissible = AdmissibleSet(
            numpy.concatenate([inner.lower, self.least]),
            numpy.concatenate([inner.upper, self.most]),
            scipy.sparse.hstack([inner.rows, nothing]).tocsr(), inner.limits)

    def force_at(self, factor):
        """What stresses a tie is a load, too."""
        return max(super().force_at(factor), self.further_load)

    def further_forces(self, run):
        """The forces in links.csv."""
        return numpy.array([float(row["force"]) for row in
                            (run.table("links.csv") if self.ties else ())])

    def further_resistance(self, jumps):
        """The most that ties take out of a motion; jumps are of their columns."""
        return numpy.maximum(-self.least * jumps, -self.most * jumps).sum()


class TieJudgement(Judgement):
    """The factor and the states beside it."""
    scenes = TiedScene

    def programme_of(self, joints, packing, dead, live):
        return TiedProgramme(joints, packing, dead, live, self.scene.ties)

    def draw(self):
        self.scene.draw_ties(self.packing)
        super().draw()
