"""Random walls and facades of dry bricks, with openings and lintels, whose
friction has no dilatancy, under weight and a live load."""
import random

import numpy

from judging.packing import Loads, number
from judging.scenes import Scene

# The numbers of bricks, by powers of ten.
LEAST_BRICKS, MOST_BRICKS = 1.5, 3.


class FacadeScene(Scene):
    """One scene, without its loads."""
    def __init__(self, seed, k):
        self.name = f"{seed}_{k}"
        self.choice = choice = random.Random(f"{seed} {k} facade")
        self.kind = choice.choice(("wall", "facade"))
        self.law = "Coulomb"
        self.rotations = True
        self.drawing = None
        n = 10. ** choice.uniform(LEAST_BRICKS, MOST_BRICKS)
        # Of the wall, and the length of bricks over their height.
        slenderness, aspect = choice.uniform(0.3, 2.), choice.uniform(1.2, 4.)
        self.courses = max(4, round((n * slenderness * aspect)**0.5))
        self.bricks = max(2, round(n / self.courses))
        self.height = self.courses / aspect
        self.width = float(self.bricks)
        self.packing = ["set Generator = wall", "subsection wall",
                        f"set Courses = {self.courses}",
                        f"set Bricks per course = {self.bricks}",
                        f"set Width = {number(self.width)}",
                        f"set Height = {number(self.height)}",
                        *self.openings(), "end"]
        self.supports = "y < 1e-9"
        self.friction = ["set Law = Coulomb", "set Coefficient = " +
                         number(choice.uniform(0.3, 0.8))]
        self.contact = []

    def openings(self):
        """Windows in rows, between courses and under lintels."""
        if self.kind == "wall" or self.bricks < 4 or self.courses < 6:
            return []
        choice = self.choice
        rise = self.height / self.courses
        n = choice.randint(1, max(1, self.bricks // 4))
        rows = choice.randint(1, max(1, self.courses // 8))
        part, storey = self.width / n, self.courses // rows
        wide = part * choice.uniform(0.25, 0.5)
        tall = max(2, round(storey * choice.uniform(0.3, 0.6)))
        boxes = []
        for row in range(rows):
            bottom = row * storey + (storey - tall) // 2
            for k in range(n):
                left = (k + 0.5) * part - 0.5 * wide
                boxes.append(", ".join(map(number, (
                    left, bottom * rise, left + wide,
                    (bottom + tall) * rise))))
        return [f"set Openings = {'; '.join(boxes)}", "set Lintels = true",
                f"set Lintel bearing = {number(0.2 * wide)}"]

    def draw_loads(self, packing):
        """Weight, in some with more on the top, and a push at all blocks or at
        those of the top, or weight on a part of it."""
        choice = self.choice
        dead = Loads(body=numpy.array((0., -1.)))
        if choice.random() < 0.4:
            dead.tractions = {"ny > 0.4873": numpy.array(
                (0., -self.height * choice.uniform(0.1, 1.)))}
        kind = choice.choice(("push", "push", "top", "slanting"))
        sense = choice.choice((-1., 1.))
        if kind == "push":
            return dead, Loads(body=numpy.array((sense, 0.)))
        if kind == "top":
            on_top = numpy.nonzero(packing.centroid[:, 1] > self.height -
                                   self.height / self.courses)[0]
            size = packing.area.sum() / len(on_top)
            return dead, Loads(forces={int(cell): numpy.array((sense * size,
                                                               0.))
                                       for cell in on_top})
        return dead, Loads(body=numpy.array((sense, choice.uniform(-0.5, 0.5))))
