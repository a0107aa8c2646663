"""Forty-nine scenes in space of known kinds, most of them with known answers:
blocks on slopes, the walls of Ferris and Tin-Loi, running bonds, facades with
side walls, grains, domes and an arch.

Their factors must be those known, and the width of what proves them is told.
"""
import math

from polyhedra import box, facade, obj_text

WANTED_WIDTH, LARGEST_WIDTH = 1e-8, 1e-6


def courses(rows, size=(0.4, 0.2, 0.175)):
    """A wall of rows of bricks, whose lengths are given in bricks."""
    length, width, height = size
    blocks = []
    for k, row in enumerate(rows):
        x = 0.
        for share in row:
            end = x + share * length
            blocks.append(("wall", box((x, 0., height * k),
                                       (end, width, height * (k + 1)))))
            x = end
    return blocks


def running_bond(n, n_courses):
    rows = ([0.5] + [1.] * (n - 1) + [0.5], [1.] * n)
    return courses([rows[k % 2] for k in range(n_courses)])


class KnownScene:
    """One of them."""
    rotations = True

    def __init__(self, kind, law, generator, dead, live, known=None,
                 digits=1e-9, where="nz < -0.5 && z < 1e-9"):
        self.kind, self.law, self.known, self.digits = kind, law, known, digits
        self.blocks = generator if isinstance(generator, list) else None
        self.generator = generator
        self.dead, self.live, self.where = dead, live, where

    def text(self):
        generator = self.generator
        if self.blocks:
            generator = "set Generator = model\nsubsection model\n" \
                f"set File = {self.name}.obj\nset Tolerance = 1e-9\nend"
        friction = "\n".join(f"set {key} = {value}"
                             for key, value in self.law_entries().items())
        return "\n".join([
            "set Dimension = 3", "set Analysis = load factor",
            "set Rotations = true", "subsection Packing", generator, "end",
            "subsection Supports", f"set Where = {self.where}", "end",
            "subsection Friction", friction, "end",
            "subsection Loads", self.dead, "end",
            "subsection Live loads", self.live, "end",
            "subsection Output", "set Report = false", "end"]) + "\n"

    def law_entries(self):
        name, *values = self.law.split()
        if name == "Tresca":
            return {"Law": "Tresca", "Strength": values[0]}
        return {"Law": "associated Coulomb", "Coefficient": values[0],
                "Cohesion": values[1] if len(values) > 1 else 0}


def body_force(x, y, z):
    return f"set Body force = {x:.17g}; {y:.17g}; {z:.17g}"


WEIGHT, PUSH = body_force(0, 0, -1), body_force(1, 0, 0)


def stress(xx, yy, zz):
    return "set Boundary load = uniform stress\n" \
        f"set Stress = {xx}, 0, 0; 0, {yy}, 0; 0, 0, {zz}"


def block(width, height):
    return [("block", box((0., 0., 0.), (1., width, height)))]


def single_blocks():
    for angle in (0., 0.2, 0.4):
        c, s = math.cos(angle), math.sin(angle)
        dead = body_force(s, 0., -c)
        low, high = block(0.5, 0.5), block(0.5, 2.)
        yield KnownScene("incline", "Coulomb 0.6", low, dead, PUSH, 0.6 * c - s)
        yield KnownScene("toppling", "Coulomb 0.9", high, dead, PUSH,
                         0.5 * c - s)
        yield KnownScene("incline", "Tresca 0.3", low, dead, PUSH, 0.6 - s)
    yield KnownScene("skew pull", "Coulomb 0.3", block(1., 0.5),
                     WEIGHT, "set Cell forces = at 0.5, 0.2, 0.5: 1, 0, 0")


def walls():
    skew = math.sqrt(0.5)
    for n_courses, known in ((6, 0.642859003), (10, 0.579998611)):
        wall = running_bond(5, n_courses)
        weight = body_force(0., 0., -10.)
        height = 0.175 * n_courses
        yield KnownScene("Ferris", "Coulomb 0.65", wall, weight,
                         body_force(10., 0., 0.), known)
        yield KnownScene("Ferris", "Tresca 10", wall, weight,
                         body_force(10., 0., 0.), 2. / (2. * height))
        yield KnownScene("Ferris", "Coulomb 0.65", wall, weight,
                         body_force(0., 10., 0.), 0.2 / height)
        yield KnownScene("Ferris", "Coulomb 0.65", wall, weight,
                         body_force(10. * skew, 10. * skew, 0.))
    for n in (8, 16, 32):
        wall = running_bond(n, n)
        yield KnownScene("wall", "Coulomb 0.65", wall, WEIGHT, PUSH,
                         0.464807962 if n == 32 else None, 4e-9)
        yield KnownScene("wall", f"Tresca {0.5 * 0.175 * n:.17g}", wall, WEIGHT,
                         PUSH, 0.5)
        yield KnownScene("wall", "Coulomb 0.65", wall, WEIGHT,
                         body_force(1., 0.2, 0.),
                         5. / 28. if n == 32 else None)


def facades():
    known = {3: 0.39976387, 4: 0.33258493, 6: 0.19805725}
    for sizes in ((3, 2, 6), (4, 3, 10), (6, 3, 16)):
        for live in ((0., -1., 0.), (1., 0., 0.)):
            for coefficient in (0.6, 0.3):
                is_known = live[0] == 0. and coefficient == 0.6
                yield KnownScene("facade", f"Coulomb {coefficient}",
                                 facade(*sizes), WEIGHT, body_force(*live),
                                 known[sizes[0]] if is_known else None, 3e-8)


def generated(seed):
    def section(name, entries):
        return "\n".join([f"set Generator = {name}", f"subsection {name}",
                          *(f"set {key} = {value}"
                            for key, value in entries.items()), "end"])
    for n in (100, 300):
        for law in ("Coulomb 0.3", "Tresca 0.3", "Coulomb 0.3 0.1"):
            yield KnownScene("grains", law, section(
                "Voronoi", {"Number of points": n, "Seed": seed}),
                stress(-1, -1, -1), stress(1, 0, -1), where="0")
    for thickness, coefficient in ((0.1, 0.5), (0.06, 0.6), (0.15, 0.3)):
        yield KnownScene("dome", f"Coulomb {coefficient}", section(
            "dome", {"Thickness": thickness, "Courses": 12, "Sectors": 16,
                     "Bond": "stack"}), WEIGHT, PUSH)
    yield KnownScene("arch", "Coulomb 0.6", section(
        "vault", {"Thickness": 0.15, "Voussoirs": 40, "Length": 0.5,
                  "Blocks per row": 1}), WEIGHT, body_force(0.8, 0.6, 0.),
        where="nz < -0.01 && abs(z) < 1e-9")


def scene(seed, k):
    """Scene @p k, from one on; random points are those of a seed."""
    scenes = [*single_blocks(), *walls(), *facades(), *generated(seed)]
    chosen = scenes[(k - 1) % len(scenes)]
    chosen.name = f"{seed}_{k}"
    return chosen


class KnownJudgement:
    """The factor of one of them."""
    scenes = staticmethod(scene)
    n_states = 0
    miss = 0.

    def __init__(self, program, chosen, report):
        self.program, self.scene, self.report = program, chosen, report
        self.kind, self.difference = "refused", 0.

    def judge(self):
        scene = self.scene
        if scene.blocks:
            self.program.write(f"{scene.name}.obj", obj_text(scene.blocks))
        run = self.program.run(scene.name, scene.text())
        factor = run.summary.get("load_factor")
        if run.status != 0 or factor is None or factor["unbounded"]:
            self.report("fault", run, run.message or "has no factor")
            return
        self.kind = "bounded"
        carried, bound = factor["carried"], float(factor["bound"])
        self.difference = abs(bound - carried) / max(abs(bound), 1e-6)
        if self.difference > WANTED_WIDTH:
            print(f"{scene.name}: {scene.kind}, {scene.law}: {carried} to "
                  f"{bound}, {self.difference:.1e} of it", flush=True)
        if self.difference > LARGEST_WIDTH:
            self.report("overruled", run, f"{carried} to {bound}")
        room = scene.digits * max(abs(bound), 1.)
        if scene.known is not None and \
                not carried - room <= scene.known <= bound + room:
            self.report("fault", run, f"{carried} to {bound}, not "
                        f"{scene.known}")
