"""Random scenes: packing, supports, friction law, and two sets of loads.

Scene k of a seed depends on these two numbers only. Its loads need the packing
that the program makes of it, and are therefore drawn later, by draw_loads().
"""
import dataclasses
import math
import random

import numpy

from judging.drawing import bricks_with_gaps, dissection, wkt_of
from judging.packing import SIDES, Loads, number

# Of the size of live loads, up and down from that of the dead ones.
DECADES = 6.

# The least strength is ten to that power.
LEAST_STRENGTH, LARGEST_COEFFICIENT = -1.5, 1.2

LAWS = ("Tresca", "Coulomb", "Coulomb, c")


@dataclasses.dataclass
class Most:
    """The largest numbers of a scene."""
    points: int
    courses: int
    bricks: int
    voussoirs: int
    polygons: int


class Scene:
    """One scene, without its loads."""
    kinds = ("Voronoi", "wall", "arch", "drawing")
    most = Most(points=60, courses=8, bricks=5, voussoirs=30, polygons=50)
    # Whether joints may crush between blocks that turn.
    has_sections = False
    # Of scenes without supports, and of others with the foot alone.
    share_floating, share_on_foot = 0.3, 0.7

    def __init__(self, seed, k):
        self.name = f"{seed}_{k}"
        self.choice = random.Random(f"{seed} {k}")
        choice = self.choice
        self.kind = choice.choice(self.kinds)
        self.law = choice.choice(LAWS)
        self.rotations = choice.random() < 0.5
        self.drawing = None
        self.width, self.height = (choice.uniform(0.3, 3.) for _ in range(2))
        self.packing = {"Voronoi": self.voronoi, "wall": self.wall,
                        "arch": self.arch, "drawing": self.polygons,
                        "gaps": self.wall_with_gaps}[self.kind]()
        self.is_floating = choice.random() < self.share_floating and \
            self.kind != "gaps"
        self.supports = "0" if self.is_floating else self.ground()
        self.friction = self.friction_entries()
        self.contact = self.contact_entries()

    def voronoi(self):
        return ["set Generator = Voronoi", "subsection Voronoi",
                f"set Number of points = {self.choice.randint(4, self.most.points)}",
                f"set Seed = {self.choice.randint(1, 10**6)}",
                f"set Upper right = {number(self.width)}, "
                f"{number(self.height)}",
                f"set Lloyd steps = {self.choice.choice((0, 0, 1, 5))}", "end"]

    def wall(self):
        bond = self.choice.choice(
            ("running", "running", "running", "stack", "English", "Flemish"))
        courses = self.choice.randint(2, self.most.courses)
        return ["set Generator = wall", "subsection wall",
                f"set Bond = {bond}", f"set Courses = {courses}",
                "set Bricks per course = "
                f"{self.choice.randint(1, self.most.bricks)}",
                f"set Width = {number(self.width)}",
                f"set Height = {number(self.height)}", "end"]

    def arch(self):
        choice = self.choice
        self.pointed = choice.random() < 0.4
        self.embrace = choice.choice((180., choice.uniform(60., 180.)))
        self.piers = choice.choice((0, 0, 1, 3))
        self.thickness = choice.uniform(0.08, 0.4)
        self.pier_height = choice.uniform(0.3, 1.5)
        voussoirs = choice.randint(4, self.most.voussoirs)
        if self.pointed:
            # Joints beside the crown must not cross.
            self.thickness = min(self.thickness, 4. / voussoirs)
        lines = ["set Generator = arch", "subsection arch",
                 f"set Thickness = {number(self.thickness)}",
                 f"set Voussoirs = {voussoirs}",
                 f"set Abutments = {self.piers}",
                 f"set Abutment height = {number(self.pier_height)}"]
        if self.pointed:
            return lines + ["set Shape = pointed", "set Radius over span = " +
                            number(choice.uniform(0.5, 1.2)), "end"]
        return lines + [f"set Embrace = {number(self.embrace)}", "end"]

    def polygons(self):
        """A drawing, which is a file beside the .prm file."""
        self.drawing = wkt_of(dissection(self.choice, self.width, self.height,
                                         self.most.polygons))
        return ["set Generator = polygons", "subsection polygons",
                f"set File = {self.name}.wkt", "end"]

    def wall_with_gaps(self):
        """A drawing of bricks with mortar between them."""
        choice = self.choice
        bricks = bricks_with_gaps(choice, self.width, self.height,
                                  choice.randint(2, self.most.courses),
                                  choice.randint(1, self.most.bricks))
        self.drawing = wkt_of(bricks.polygons)
        return ["set Generator = polygons", "subsection polygons",
                f"set File = {self.name}.wkt",
                f"set Joint width = {number(1.01 * bricks.gap)}", "end"]

    def ground(self):
        """The supports: the foot, or several sides, which may clamp."""
        sides = ["y < 1e-9", f"y > {number(self.height)} - 1e-9", "x < 1e-9",
                 f"x > {number(self.width)} - 1e-9"]
        if self.kind == "arch":
            return self.springings()
        if self.choice.random() < self.share_on_foot:
            return sides[0]
        chosen = self.choice.sample(sides, self.choice.randint(2, 4))
        return " || ".join(chosen)

    def springings(self):
        """The foot of an arch, in some with what is beside its haunches."""
        if self.pointed:
            foot = -self.pier_height if self.piers else 0.
            below = f"y < {number(foot + 1e-9)}"
        elif self.piers:
            half = math.radians(0.5 * self.embrace)
            foot = (1. - 0.5 * self.thickness) * math.cos(half) \
                - self.pier_height
            below = f"ny < -0.99 && y < {number(foot + 1e-6)}"
        else:
            below = "abs(x*nx + y*ny) < 1e-6"
        if self.choice.random() < 0.8:
            return below
        return f"({below}) || (abs(nx) > 0.7 && x*nx > 0)"

    def friction_entries(self):
        """The friction law, in some scenes with another one on level joints."""
        choice = self.choice

        def expression(draw):
            value = number(draw())
            if choice.random() < 0.7:
                return value
            return f"abs(ny) > 0.5123 ? {value} : {number(draw())}"

        def strength():
            return 10. ** choice.uniform(LEAST_STRENGTH, 0.7)

        if self.law == "Tresca":
            return [f"set Strength = {expression(strength)}"]
        lines = ["set Law = associated Coulomb", "set Coefficient = " +
                 expression(lambda: choice.uniform(0.05, LARGEST_COEFFICIENT))]
        if self.law == "Coulomb, c":
            lines.append(f"set Cohesion = {expression(strength)}")
        return lines

    def contact_entries(self):
        """In some scenes tension, within Coulomb's cone, and crushing."""
        choice = self.choice
        lines = []
        if self.law != "Coulomb" and choice.random() < 0.3:
            most = 10. ** LEAST_STRENGTH / LARGEST_COEFFICIENT
            lines.append("set Tensile strength = " +
                         number(most * choice.uniform(0.1, 1.)))
        if (self.has_sections or not self.rotations) and \
                choice.random() < 0.3:
            lines.append("set Compressive strength = " +
                         number(10. ** choice.uniform(-0.5, 1.)))
        return lines

    def text(self, settings=(), loads=None, live=None):
        """The .prm file with these loads; settings are further lines."""
        sections = {"Packing": self.packing,
                    "Supports": [f"set Where = {self.supports}"],
                    "Friction": self.friction, "Contact": self.contact,
                    "Output": ["set Files = csv", "set Packing = WKT"]}
        if loads is not None:
            sections["Loads"] = loads.entries()
        if live is not None:
            sections["Live loads"] = live.entries()
        lines = ["set Accuracy = draft",
                 f"set Rotations = {str(self.rotations).lower()}", *settings]
        for name, entries in sections.items():
            lines += [f"subsection {name}", *entries, "end"]
        return "\n".join(lines) + "\n"


class SmallScene(Scene):
    """One that is solved a hundred times."""
    kinds = Scene.kinds + ("gaps",)
    most = Most(points=20, courses=5, bricks=3, voussoirs=14, polygons=20)
    has_sections = True


class StandingScene(SmallScene):
    """One whose supports can move."""
    share_floating, share_on_foot = 0., 0.9


class GivenScene:
    """The text of a .prm file, which writes its packing."""
    kind, law = "file", ""

    def __init__(self, path):
        self.name = path.stem
        self.text = path.read_text() + (
            "subsection Output\nset Files = csv\nset Packing = WKT\nend\n")
        self.rotations = "set Rotations = true" in self.text
        self.drawings = {drawing.name: drawing.read_text()
                         for drawing in path.parent.glob("*.wkt")}


def draw_loads(scene, packing):
    """The dead and the live loads of a scene with this packing."""
    choice = scene.choice
    if scene.kind == "gaps":
        dead, live = loads_of_blocks(choice, packing)
    elif scene.is_floating:
        dead = Loads(stress=compression(choice))
        live = floating_live_loads(choice, packing)
    else:
        dead = standing_dead_loads(choice, packing)
        live = standing_live_loads(choice, packing)
        if not numpy.any(live.on(packing)):
            # Nothing of the boundary is free.
            live.body = numpy.array((1., 0.3))
    if choice.random() < 0.08:
        dead = Loads()
    return dead, Loads().plus(10. ** choice.uniform(-DECADES, DECADES), live)


def compression(choice):
    """A stress with two compressive principal stresses."""
    xx, yy = (-choice.uniform(0.1, 2.) for _ in range(2))
    xy = choice.uniform(-0.9, 0.9) * math.sqrt(xx * yy)
    return numpy.array([[xx, xy], [xy, yy]])


def any_stress(choice):
    xx, xy, yy = (choice.uniform(-1., 1.) for _ in range(3))
    return numpy.array([[xx, xy], [xy, yy]])


def floating_live_loads(choice, packing):
    """A stress, or forces between the centroids of two cells."""
    if choice.random() < 0.6 or len(packing) < 2:
        return Loads(stress=any_stress(choice))
    a, b = choice.sample(range(len(packing)), 2)
    force = choice.uniform(-1., 1.) * (packing.centroid[b] - packing.centroid[a])
    return Loads(forces={a: force, b: -force})


def vector(choice, size):
    """One of any direction."""
    angle = choice.uniform(-math.pi, math.pi)
    return size * numpy.array((math.cos(angle), math.sin(angle)))


def forces_on_some(choice, packing):
    """Forces on two cells, about as large as they are."""
    cells = choice.sample(range(len(packing)), min(len(packing), 2))
    return Loads(forces={cell: vector(choice, packing.area[cell])
                         for cell in cells})


def loads_of_blocks(choice, packing):
    """Loads that do not depend on which parts of sides are free."""
    height = numpy.ptp(numpy.concatenate(packing.polygons)[:, 1])
    dead = Loads(body=numpy.array((0., -1. / height)))
    if choice.random() < 0.5:
        return dead, Loads(body=vector(choice, 1.))
    return dead, forces_on_some(choice, packing)


def standing_dead_loads(choice, packing):
    """Weight, in some scenes with a pressure or a traction beside it."""
    height = numpy.ptp(numpy.concatenate(packing.polygons)[:, 1])
    dead = Loads(body=numpy.array((0., -1. / height)))
    if choice.random() < 0.3:
        dead.stress = 0.5 * compression(choice)
    if choice.random() < 0.2:
        dead.tractions = {"ny > 0.4873": numpy.array((0., -choice.random()))}
    return dead


def standing_live_loads(choice, packing):
    """One of four loads."""
    kind = choice.choice(("body", "stress", "traction", "forces"))
    if kind == "body":
        return Loads(body=vector(choice, 1.))
    if kind == "stress":
        return Loads(stress=any_stress(choice))
    if kind == "traction":
        side = choice.choice(sorted(SIDES))
        return Loads(tractions={side: vector(choice, 1.)})
    return forces_on_some(choice, packing)
