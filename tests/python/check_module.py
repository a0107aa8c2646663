"""The module of Python: its numbers, its memory, and its errors.

    python3 check_module.py SOURCE_DIRECTORY PROGRAM
"""
import csv
import gc
import os
import re
import resource
import subprocess
import sys

import numpy as np
import voussoir

from checks import PROGRAM, SOURCE, expect

SQUARES = [np.array([[0, k], [1, k], [1, k + 1], [0, k + 1]], float) for k in range(3)]
STANDING = {"Supports/Where": "y < 1e-9", "Loads/Body force": "0; -1",
            "Friction/Strength": 1, "Formulation": "least energy"}


def raised(kind, what, action):
    """The message of the exception that @p action raises."""
    try:
        action()
    except kind as error:
        return str(error)
    sys.exit(f"{what}: nothing was raised")


def columns(file, *names):
    with open(file, newline="") as lines:
        rows = list(csv.DictReader(lines))
    return [np.array([float(r[n]) for r in rows]) for n in names]


def check_text():
    """A text may name load cases, and a file may be in JSON."""
    text = """
        subsection Packing
          set Generator = wall
        end
        subsection Supports
          set Where = ny < -0.5
        end
        subsection Load cases
          subsection dead
            set Body force = 0; -1
          end
        end
        subsection Loads
          set Combination = 2 dead
        end
    """
    found = voussoir.Scene(text=text).solve()
    expect("a load case of a text", np.isclose(found.loads[:, 1].sum(), -2))
    with open("wall.json", "w") as file:
        subprocess.run([PROGRAM, f"{SOURCE}/prm/arch.prm", "--print-settings", "--as", "json"],
                       check=True, stdout=file)
    expect("a file in JSON", np.array_equal(
        voussoir.Scene("wall.json").solve().normal_force,
        voussoir.Scene(f"{SOURCE}/prm/arch.prm").solve().normal_force))


def check_like_the_program():
    """A scene has the numbers that the program writes."""
    file = f"{SOURCE}/prm/semicircular_arch.prm"
    subprocess.run([PROGRAM, file, "--quiet", "--set", "Output directory=arch",
                    "--set", "Output/Files=csv"], check=True)
    found = voussoir.Scene(file).solve()
    expect("status", found.status == "solved")
    for name, of in (("normal_force", found.normal_force),
                     ("tangential_force", found.tangential_force),
                     ("utilisation", found.utilisation),
                     ("eccentricity", found.eccentricity),
                     ("normal_force_0", found.end_forces[:, 0]),
                     ("x0", found.starts[:, 0]), ("y1", found.ends[:, 1]),
                     ("nx", found.normals[:, 0]), ("length", found.lengths),
                     ("cell_minus", found.cell_minus), ("cell_plus", found.cell_plus),
                     ("strength", found.strength), ("branch_y", found.branch[:, 1])):
        expect(name, np.array_equal(columns("arch/interfaces.csv", name)[0], of))
    for name, of in (("sxy", found.stress[:, 0, 1]), ("syy", found.stress[:, 1, 1]),
                     ("load_y", found.loads[:, 1]), ("area", found.areas),
                     ("x", found.centres[:, 0]), ("torque", found.torque),
                     ("load_torque", found.load_torque),
                     ("ux", found.displacement[:, 0]), ("rotation", found.rotation)):
        expect(name, np.array_equal(columns("arch/cells.csv", name)[0], of))
    expect("force and normal", np.allclose(
        found.normal_force, (found.force * found.normals).sum(axis=1), atol=1e-12))
    expect("no ranges", "with `Ranges` of interfaces only" in raised(
        AttributeError, "ranges", lambda: found.p_min))
    expect("help", type(found).p_min.__doc__.endswith("S L."))
    expect("summary", found.summary["certificate"]["equilibrium_residual"] < 1e-9)


def check_samples():
    """Samples have the numbers that the program writes, with their errors, or none."""
    file = f"{SOURCE}/prm/portal.prm"
    subprocess.run([PROGRAM, file, "--quiet", "--set", "Output directory=samples",
                    "--set", "Output/Files=csv", "--set", "Ranges/Samples=400"], check=True)
    scene = voussoir.Scene(file)
    expect("no samples", "set 'Ranges/Samples'" in raised(
        AttributeError, "samples", lambda: scene.solve().p_mean))
    scene["Ranges/Samples"] = 400
    found = scene.solve()
    for name in ("p_mean", "p_mean_error", "p_deviation", "q_mean", "q_mean_error",
                 "q_deviation"):
        expect(name, np.array_equal(columns("samples/interfaces.csv", name)[0],
                                    getattr(found, name)))
    samples = found.summary["samples"]
    expect("effective", samples["settled"] and samples["effective_number"] >= 400)
    expect("error", np.isclose(samples["largest_error"],
                               max(found.p_mean_error.max(), found.q_mean_error.max())))
    scene["Ranges/Steps between samples"] = 1
    found = scene.solve()
    expect("too few steps", not found.summary["samples"]["settled"] and
           "largest_error" not in found.summary["samples"])
    expect(f"warnings {found.warnings}", any(re.fullmatch(
        r"The samples have not settled, and give no mean: with 1 step from one to the next 400 of "
        r"them are worth \d+ independent ones for the worst force, and must be worth 100; the "
        r"spread of a force in all chains together is [\d.]+ times that within each, and must be "
        r"at most 1\.1\. Set 'Ranges/Steps between samples' to more than 1, or to 0, which finds "
        r"how many it takes\.", warning) for warning in found.warnings))
    subprocess.run([PROGRAM, file, "--quiet", "--set", "Output directory=samples",
                    "--set", "Output/Files=all", "--set", "Ranges/Samples=400",
                    "--set", "Ranges/Steps between samples=1"], check=True)
    with open("samples/interfaces.csv", newline="") as lines:
        expect("empty columns", all(
            joint[name] == "" for joint in csv.DictReader(lines)
            for name in ("p_mean", "p_mean_error", "p_deviation", "q_mean", "q_mean_error",
                         "q_deviation", "correlation")))
    with open("samples/interfaces.vtu", "rb") as grid:
        expect("no field", b"p_mean" not in grid.read())
    with open("samples/report.html") as page:
        expect("the report", "have not settled, and give no mean" in page.read())
    expect("no mean", "have not settled" in raised(
        AttributeError, "no mean", lambda: found.p_mean))


def check_polygons():
    """A column of squares of weight one, drawn by arrays."""
    scene = voussoir.Scene(polygons=SQUARES, settings=STANDING)
    found = scene.solve()
    # Between the squares, then on the ground.
    expect("forces", np.allclose(found.normal_force, [-2, -1, -3], atol=1e-12))
    expect("corners", all(np.array_equal(a, b) for a, b in zip(found.polygons, SQUARES)))
    expect("areas", np.allclose(scene.areas, 1) and len(scene.groups) == 3)
    expect("an entry", scene["Friction/Strength"] == "1")
    scene["Loads/Body force"] = "0; -2"
    expect("other loads", np.allclose(scene.solve().normal_force, 2 * found.normal_force))
    scene.set("Loads/Body force", "1.5; -1")
    pushed = scene.solve()
    expect("collapse", pushed.status == "collapse" and
           pushed.summary["mechanism"]["work_over_dissipation"] > 1)
    expect("mechanism", np.abs(pushed.displacement).max() > 0)
    expect("jumps", np.abs(pushed.sliding).max() > 0 and pushed.dissipation.sum() > 0)
    message = raised(AttributeError, "no forces", lambda: pushed.normal_force)
    expect(message, "not carried" in message)
    scene["Analysis"] = "load factor"
    scene["Loads/Body force"] = "0; -1"
    scene["Live loads/Body force"] = "1; 0"
    factor = scene.solve().summary["load_factor"]
    expect("load factor", abs(factor["carried"] - 1 / 3) < 1e-7)
    # The packing is made again if it has to be.
    scene["Analysis"] = "state"
    scene["Supports/Where"] = "y > 3 - 1e-9"
    expect("hanging", scene.solve().status == "collapse")
    for name, value in (("Friction/Law", "Coulomb"), ("Friction/Coefficient", 0.5),
                        ("Friction/Cohesion", 2), ("Contact/Tensile strength", 3.5)):
        scene[name] = value
    glued = scene.solve()
    expect("glued", glued.status == "solved" and
           np.allclose(sorted(glued.normal_force), [1, 2, 3], atol=1e-9))
    expect("by least energy", "least energy" in glued.summary["selection"])


def check_packing():
    """The packing is that of the entries, in whatever order they are set."""
    blocks = [np.array([[0, 0], [2, 0], [2, 1], [0, 1]], float),
              np.array([[1, 1], [1.5, 2], [0.5, 2]], float)]
    scene = voussoir.Scene(polygons=blocks, settings={
        "Supports/Where": "y < 1e-9", "Loads/Body force": "0; y < 1 ? -1 : 0",
        "Friction/Strength": 1, "Formulation": "least energy"})
    for turn in (False, True, False):
        scene["Friction/Strength"] = 2
        scene["Rotations"] = turn
        found = scene.solve()
        expect(f"a corner, Rotations = {turn}",
               len(found.cell_plus) == len(scene.cell_plus) == (2 if turn else 1))
        # Of a packing that is kept, too.
        for again in (found, scene.solve()):
            expect("a notice", sum("a corner only" in w for w in again.warnings) == turn)


def check_warnings():
    """They are those of the program."""
    pushed = dict(STANDING, **{"Loads/Body force": "0.4; -1", "Friction/Strength": 10,
                               "Friction/Coefficient": 0.6})
    for _ in range(2):
        scene = voussoir.Scene(polygons=SQUARES, settings=pushed)
        for _ in range(2):
            warnings = scene.solve().warnings
            expect(warnings, len(warnings) == 2)
            expect("unused", warnings[0] == "'Coefficient' in 'Friction' has no effect, "
                                            "since 'Friction/Law' is 'Tresca'.")
            expect("doubts", "would overturn" in warnings[1])
    # A factor without bound is none.
    scene = voussoir.Scene(polygons=SQUARES, settings=dict(STANDING, **{
        "Analysis": "load factor", "Live loads/Body force": "0; -1"}))
    factor = scene.solve().summary["load_factor"]
    expect(factor, factor["unbounded"] and factor["carried"] is None
           and factor["bound"] is None and factor["forces_at"] == 1)


def check_links():
    """A tie, in a state and in the mechanism that bounds a factor."""
    scene = voussoir.Scene(settings={
        "Packing/Generator": "wall", "Packing/wall/Courses": 1,
        "Packing/wall/Bricks per course": 1, "Rotations": True, "Supports/Where": "y < 1e-9",
        "Analysis": "load factor", "Friction/Law": "associated Coulomb",
        "Friction/Coefficient": 0.2, "Loads/Body force": "0; -1",
        "Live loads/Body force": "1; 0", "Ties/rod/From": "cell 0",
        "Ties/rod/To": "ground at -1, 0.5", "Ties/rod/Yield force": 0.3})
    found = scene.solve()
    expect("the factor of a block with a tie",
           abs(found.summary["load_factor"]["carried"] - 0.5) < 1e-8)
    expect("the force of the tie", abs(found.link_forces[0] - 0.3) < 1e-8)
    expect("its names and places", list(found.link_names) == ["rod"] and
           np.allclose(found.link_ends, [[-1., 0.5]]))
    expect("it is drawn out", found.link_elongations[0] > 0.)


def check_variables():
    """The variables of a scene may change, and all that has them follows."""
    text = ("subsection Variables\n set h = 2\n set b = h / 2\nend\n"
            "subsection Packing\n set Generator = wall\n subsection wall\n"
            "  set Width = $b\n  set Height = $h\n end\nend\n"
            "subsection Supports\n set Where = y < 1e-9\nend\n"
            "subsection Friction\n set Strength = 10\nend\n")
    scene = voussoir.Scene(text=text, settings={"Loads/Body force": "0; -$(1 / b)"})

    def weight():
        return scene.solve().summary["loads"]["total"][1]
    expect("a weight", abs(weight() + 2) < 1e-12)
    scene["Variables/h"] = 6
    expect("another height", abs(weight() + 6) < 1e-12)
    raised(voussoir.InputError, "no number",
           lambda: scene.__setitem__("Variables/h", "1/0"))
    raised(voussoir.InputError, "no size",
           lambda: scene.__setitem__("Variables/h", -6))
    expect("the height of before", abs(weight() + 6) < 1e-12)
    scene["Loads/Body force"] = "0; -$h"
    expect("another load", abs(weight() + 6 * 3 * 6) < 1e-12)


def check_errors():
    """The messages are those of the program."""
    message = raised(voussoir.InputError, "a name",
                     lambda: voussoir.Scene(settings={"Friction/Strenght": 1}))
    expect(message, "did you mean 'Friction/Strength'?" in message)
    message = raised(voussoir.InputError, "no name", lambda: voussoir.Scene(""))
    expect(message, "cannot be read" in message)
    expect("InputError is a ValueError", issubclass(voussoir.InputError, ValueError))
    overlapping = [SQUARES[0], SQUARES[0] + 0.5]
    message = raised(voussoir.InputError, "an overlap",
                     lambda: voussoir.Scene(polygons=overlapping).solve())
    expect(message, "polygon 2" in message and "the arrays" in message)
    raised(ValueError, "a shape", lambda: voussoir.Scene(polygons=[np.zeros((4, 3))]))
    raised(KeyError, "an entry", lambda: voussoir.Scene()["Friction/None"])
    # A scene can be used after an error.
    scene = voussoir.Scene(polygons=SQUARES, settings=STANDING)
    scene["Friction/Strength"] = "-1"
    raised(voussoir.InputError, "a strength", scene.solve)
    scene["Friction/Strength"] = 1
    expect("after an error", scene.solve().status == "solved")


def check_views():
    """Arrays show the memory of the results, and keep it."""
    found = voussoir.Scene(polygons=SQUARES, settings=STANDING).solve()
    force, stress, starts = found.normal_force, found.stress, found.starts
    expect("no copy", force.ctypes.data == found.normal_force.ctypes.data)
    raised(ValueError, "not to be written to", lambda: force.__setitem__(0, 1.0))
    before = force.copy(), stress.copy(), starts.copy()
    del found
    gc.collect()
    expect("kept", all(np.array_equal(a, b) for a, b in zip((force, stress, starts), before)))


def check_memory():
    """Nothing is left behind by many solves."""
    scene = voussoir.Scene(polygons=SQUARES, settings=STANDING)

    def solve(n):
        for k in range(n):
            scene["Loads/Body force"] = f"0; {-1 - k % 7}"
            scene.solve().normal_force
        gc.collect()
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss  # kB

    solve(1000)
    before = solve(1000)
    after = solve(10000)
    expect(f"memory, {before} and {after} kB", after - before < 2000)


check_like_the_program()
check_text()
check_samples()
check_polygons()
check_packing()
check_warnings()
check_variables()
check_links()
check_errors()
check_views()
check_memory()
print("OK")
