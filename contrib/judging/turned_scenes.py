"""Random scenes that stand at any angle, and of which the dead loads alone may
be too much: columns, stacks that lean, seesaws, walls, arches and drawings.

Scene k of a seed depends on these two numbers only. They are drawn upright and
turned as a whole, with their loads.
"""
import math
import random

import numpy

from judging.drawing import (dissection, rectangle, running_bond, voussoirs,
                             wkt_of)
from judging.packing import Loads, number
from judging.scenes import (LAWS, Scene, any_stress, compression,
                            forces_on_some, vector)

# Of the size of live loads, up and down from that of the dead ones.
DECADES = 3.


class TurnedScene(Scene):
    """One scene, without its loads."""
    kinds = ("column", "stack", "seesaw", "wall", "arch", "drawing")
    share_upright, share_floating = 0.2, 0.4

    def __init__(self, seed, k):
        self.name = f"{seed}_{k}"
        self.choice = choice = random.Random(f"{seed} {k} turned")
        self.kind = choice.choice(self.kinds)
        self.law = choice.choice(LAWS)
        self.rotations = choice.random() < 0.6
        self.width, self.height = (choice.uniform(0.3, 3.) for _ in range(2))
        polygons = {"column": self.column, "stack": self.stack,
                    "seesaw": self.seesaw, "wall": self.bricks,
                    "arch": self.ring, "drawing": self.cut}[self.kind]()
        self.height = numpy.ptp(numpy.concatenate(polygons)[:, 1])
        self.angle = 0. if choice.random() < self.share_upright else \
            choice.uniform(-math.pi, math.pi)
        self.drawing = wkt_of([polygon @ self.turn().T
                               for polygon in polygons])
        self.packing = ["set Generator = polygons", "subsection polygons",
                        f"set File = {self.name}.wkt", "end"]
        self.is_floating = self.kind == "drawing" and \
            choice.random() < self.share_floating
        self.supports = "0" if self.is_floating else \
            f"({number(-math.sin(self.angle))})*x + " \
            f"({number(math.cos(self.angle))})*y < 1e-7"
        self.friction = self.friction_entries()
        self.contact = self.contact_entries()

    def turn(self):
        """The rotation by its angle."""
        c, s = math.cos(self.angle), math.sin(self.angle)
        return numpy.array(((c, -s), (s, c)))

    def column(self):
        """Blocks on each other, about as wide."""
        return self.pile(0.1)

    def stack(self):
        """Blocks that lean outwards by more than some bear."""
        return self.pile(0.8)

    def pile(self, most):
        """Blocks on each other, each moved by a share of the one below."""
        choice = self.choice
        polygons, left, bottom = [], 0., 0.
        width = self.width
        lean = choice.choice((-1., 1.)) * choice.uniform(0., most)
        for _ in range(choice.randint(1, 6)):
            height = choice.uniform(0.2, 1.2)
            polygons.append(rectangle(left, bottom, width, height))
            wider = width * choice.uniform(0.8, 1.2)
            # No corner on a corner, nor nothing below.
            step = min(max(lean * choice.uniform(0.5, 1.) * width,
                           -0.9 * wider), 0.9 * width) + 0.01 * width
            left, bottom, width = left + step, bottom + height, wider
        return polygons

    def seesaw(self):
        """A beam on a foot, and blocks on it."""
        choice = self.choice
        foot, height = choice.uniform(0.05, 1.), choice.uniform(0.2, 1.)
        half = 0.5 * foot + choice.uniform(0., 0.5)
        base = numpy.array(((-half, 0.), (half, 0.), (0.5 * foot, height),
                            (-0.5 * foot, height)))
        left = -choice.uniform(0.6, 2.)
        width, depth = choice.uniform(0.7, 2.) - left, choice.uniform(0.1, 0.4)
        polygons = [base, rectangle(left, height, width, depth)]
        for place in (0.02, 0.41, 0.78)[:choice.randint(1, 3)]:
            polygons.append(rectangle(
                left + place * width, height + depth, width *
                choice.uniform(0.1, 0.2), choice.uniform(0.1, 0.8)))
        return polygons

    def bricks(self):
        return running_bond(self.width, self.height,
                            self.choice.randint(2, 7),
                            self.choice.randint(1, 4))

    def ring(self):
        return voussoirs(self.choice.randint(4, 20),
                         self.choice.uniform(0.06, 0.4))

    def cut(self):
        return dissection(self.choice, self.width, self.height, 30)

    def draw_loads(self, packing):
        """The dead and the live loads; in half of the scenes some of the live
        ones act all the time, so that the dead ones alone may be too much."""
        choice = self.choice
        if self.is_floating:
            dead = Loads(stress=choice.choice((compression, any_stress))(choice))
            live = Loads(stress=any_stress(choice))
        else:
            dead = Loads(body=numpy.array((0., -1. / self.height)))
            if choice.random() < 0.4:
                turn = choice.gauss(0., 0.6)
                dead.body = dead.body[1] * numpy.array((math.sin(turn),
                                                        math.cos(turn)))
            if choice.random() < 0.2:
                dead.stress = 0.5 * compression(choice)
            live = choice.choice((
                lambda: Loads(body=vector(choice, 1.)),
                lambda: Loads(body=numpy.array((choice.choice((-1., 1.)), 0.))),
                lambda: Loads(stress=any_stress(choice)),
                lambda: forces_on_some(choice, packing)))()
        if choice.random() < 0.5:
            dead = dead.plus(choice.choice((-1., 1.)) *
                             10.**choice.uniform(-1., 1.), live)
        live = Loads().plus(10.**choice.uniform(-DECADES, DECADES), live)
        return dead.turned(self.turn()), live.turned(self.turn())
