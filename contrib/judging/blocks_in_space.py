"""Random scenes in space: a generator, supports, a law of friction and loads.

Scene k of a seed depends on these two numbers only.
"""
import math
import random

import numpy

KINDS = ("wall", "vault", "dome", "column", "stairs", "grains")
LAWS = ("Tresca", "Coulomb", "Coulomb, c")
# The least strength is ten to that power.
LEAST_STRENGTH = -1.5


def vector(values):
    return "; ".join(f"{value:.17g}" for value in values)


class SpaceScene:
    """One scene; its loads are body forces, or stresses on a box of grains."""
    kinds = KINDS
    laws = LAWS
    bears_tension = True

    def __init__(self, seed, k):
        draw = self.draw = random.Random(f"{seed} {k} in space")
        self.name = f"{seed}_{k}"
        self.kind = KINDS[k % len(KINDS)]
        self.law = draw.choice(self.laws)
        self.rotations = draw.random() < 0.7
        self.coefficient = draw.choice((0.1, 0.3, 0.6, 1., 1.5)) \
            if self.law != "Tresca" else 0.
        self.strength = 10.**draw.uniform(LEAST_STRENGTH, 1.) \
            if self.law != "Coulomb" else 0.
        self.tension = 0.
        if draw.random() < 0.2 and self.strength > 0. and self.bears_tension:
            most = self.strength / self.coefficient if self.coefficient \
                else self.strength
            self.tension = draw.uniform(0., min(most, 1.))
        self.cells = draw.choice((1, 1, 2)) if self.rotations else 1
        self.generator, self.supports = getattr(self, self.kind)()
        self.is_stressed = self.kind == "grains"
        if self.is_stressed:
            self.dead = -numpy.eye(3)
            live = numpy.array([[draw.uniform(-1., 1.) for _ in range(3)]
                                for _ in range(3)])
            self.live = live + live.T
        else:
            weight = 10.**draw.uniform(-1., 1.)
            self.dead = numpy.array((0., 0., -weight))
            direction = numpy.array([draw.gauss(0., 1.) for _ in range(3)])
            if draw.random() < 0.3:
                direction[draw.randrange(3)] = 0.
            self.live = weight * direction / numpy.linalg.norm(direction)
        self.sense = draw.choice(("greatest", "greatest", "least"))

    def section(self, name, entries):
        lines = "\n".join(f"    set {key} = {value}"
                          for key, value in entries.items())
        return f"  set Generator = {name}\n  subsection {name}\n{lines}\n  end"

    def wall(self):
        draw = self.draw
        bond = draw.choice(("running", "English", "Flemish"))
        leaves = 1 if bond == "running" else 2
        n, m = draw.randint(2, 4), draw.randint(2, 6 if leaves == 1 else 4)
        entries = {"Bond": bond, "Length": n, "Thickness": 0.5 * leaves,
                   "Height": 0.3 * m, "Brick length": 1, "Brick width": 0.5,
                   "Brick height": 0.3}
        return self.section("wall", entries), "z < 1e-9"

    def vault(self):
        draw = self.draw
        entries = {"Embrace": draw.choice((90, 120, 160, 180)),
                   "Thickness": draw.uniform(0.08, 0.3),
                   "Voussoirs": draw.randint(3, 9), "Length": 1,
                   "Blocks per row": draw.randint(1, 3),
                   "Bond": draw.choice(("running", "stack"))}
        # The springings are planes through the axis.
        half = math.radians(entries["Embrace"] / 2.)
        return self.section("vault", entries), \
            f"nz < -0.01 && abs(abs(nx) - {math.cos(half):.15g}) < 1e-6 " \
            f"&& abs(ny) < 1e-6"

    def dome(self):
        draw = self.draw
        entries = {"Thickness": draw.uniform(0.06, 0.3),
                   "Courses": draw.randint(2, 4), "Sectors": draw.randint(4, 8),
                   "Bond": draw.choice(("running", "stack"))}
        return self.section("dome", entries), "nz < -0.5 && z < 1e-9"

    def column(self):
        draw = self.draw
        entries = {"Drums": draw.randint(1, 5), "Sides": draw.randint(3, 10),
                   "Height": draw.uniform(1., 6.), "Bottom radius": 0.5,
                   "Top radius": draw.uniform(0.3, 0.5)}
        return self.section("column", entries), "z < 1e-9"

    def stairs(self):
        draw = self.draw
        entries = {"Steps": draw.randint(2, 4), "Courses above": 2,
                   "Bearing": draw.uniform(0.1, 0.25)}
        return self.section("stairs", entries), "z < 1e-9 && nz < -0.5"

    def grains(self):
        entries = {"Number of points": self.draw.randint(3, 30),
                   "Seed": self.draw.randrange(1000)}
        return self.section("Voronoi", entries), "0"

    def law_text(self):
        lines = ["subsection Friction"]
        if self.law == "Tresca":
            lines += ["set Law = Tresca", f"set Strength = {self.strength:.17g}"]
        else:
            lines += ["set Law = associated Coulomb",
                      f"set Coefficient = {self.coefficient:.17g}",
                      f"set Cohesion = {self.strength:.17g}"]
        lines += ["end", "subsection Contact",
                  f"set Tensile strength = {self.tension:.17g}"]
        if self.rotations:
            lines += [f"set Friction cells = {self.cells}"]
        return "\n".join(lines + ["end"])

    def loads_text(self, section, load):
        if self.is_stressed:
            rows = "; ".join(", ".join(f"{value:.17g}" for value in row)
                             for row in load)
            lines = ["set Boundary load = uniform stress", f"set Stress = {rows}"]
        else:
            lines = [f"set Body force = {vector(load)}"]
        return "\n".join([f"subsection {section}", *lines, "end"])

    def text(self, factor=None, further=()):
        """A run for the load factor, or for the state with @p factor, and
        further lines."""
        analysis = "load factor" if factor is None else "state"
        lines = ["set Dimension = 3", f"set Analysis = {analysis}",
                 f"set Rotations = {str(self.rotations).lower()}",
                 "subsection Packing", self.generator, "end",
                 "subsection Supports", f"set Where = {self.supports}", "end",
                 self.law_text(), "subsection Output", "set Report = false",
                 "end"]
        if factor is None:
            lines += [self.loads_text("Loads", self.dead),
                      self.loads_text("Live loads", self.live),
                      "subsection Load factor",
                      f"set Direction = {self.sense}", "end"]
        else:
            lines += [self.loads_text("Loads", self.dead + factor * self.live)]
        return "\n".join([*lines, *further]) + "\n"
