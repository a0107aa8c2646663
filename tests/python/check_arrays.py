"""Arrays as the values of entries: strengths of joints, and loads of blocks.

    python3 check_arrays.py SOURCE_DIRECTORY PROGRAM
"""
import numpy as np
import voussoir
from checks import SOURCE, expect, numbers, raised, run_program, table

WALL = {"Packing/Generator": "wall", "Packing/wall/Courses": 3, "Packing/wall/Bricks per course": 2,
        "Supports/Where": "y < 1e-9", "Loads/Body force": "0; -1"}
BOX = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
FACES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
TOWER = [(BOX + [0, 0, k], FACES) for k in range(3)]


def check_joints():
    """An array gives what an expression gives, and the results have it."""
    scene = voussoir.Scene(settings=dict(WALL, **{"Friction/Strength": "1 + y + nx^2"}))
    by_formula = scene.solve()
    expect("numbers", scene.n_joints == len(scene.lengths) == len(by_formula.normal_force)
           and scene.n_blocks == len(scene.areas) == by_formula.n_blocks)
    middle = (scene.starts[:, 1] + scene.ends[:, 1]) / 2
    strengths = 1 + middle + scene.normals[:, 0]**2
    scene["Friction/Strength"] = strengths
    found = scene.solve()
    expect("strengths", np.array_equal(found.strength, strengths))
    expect("the same", np.allclose(found.strength, by_formula.strength, rtol=1e-14) and
           np.allclose(found.normal_force, by_formula.normal_force, atol=1e-9))
    expect("its text", scene["Friction/Strength"].startswith("list "))
    # Pairs have their own values, and other kinds of arrays are numbers, too.
    scene["Friction/Pair strengths"] = "wall, ground: 7" if "wall" in scene.groups else (
        f"{scene.groups[0]}, ground: 7")
    scene["Friction/Strength"] = np.arange(1, scene.n_joints + 1)[::-1].astype(np.int32)
    found = scene.solve()
    on_ground = found.cell_plus < 0
    expect("pairs", np.array_equal(found.strength[~on_ground],
                                   np.arange(scene.n_joints, 0, -1)[~on_ground])
           and 7. in found.strength[on_ground])


def check_laws():
    """All strengths may be arrays; those of one joint decide."""
    scene = voussoir.Scene(settings=dict(WALL, **{"Friction/Law": "associated Coulomb"}))
    n = scene.n_joints
    rising = np.linspace(0.4, 0.9, n)
    limits = np.full(n, np.inf)
    limits[0] = 50.
    for entry, attribute, values in (
            ("Friction/Coefficient", "coefficient", rising),
            ("Friction/Cohesion", "strength", 2 * rising),
            ("Contact/Tensile strength", "tensile_strength", rising / 10),
            ("Contact/Compressive strength", "compressive_strength", limits)):
        scene[entry] = values
        expect(entry, np.array_equal(getattr(scene.solve(), attribute), values))
    scene["Friction/Law"] = "Mohr-Coulomb"
    scene["Friction/Friction angle"] = 40 * rising
    expect("angles", np.allclose(scene.solve().coefficient, np.tan(np.radians(40 * rising))))
    # Three squares on one another under a pull of one each: a slit at any of them
    # frees what is above. The factor is the weakest joint's.
    squares = [np.array([[0, k], [1, k], [1, k + 1], [0, k + 1]], float) for k in range(3)]
    scene = voussoir.Scene(polygons=squares, settings={
        "Supports/Where": "y < 1e-9", "Analysis": "load factor", "Live loads/Body force": "1; 0"})
    above = 3 - np.minimum(scene.starts[:, 1], scene.ends[:, 1])
    for strengths in ([1., 1., 1.], [0.3, 1., 2.], [5., 0.2, 9.]):
        scene["Friction/Strength"] = np.array(strengths)
        factor = scene.solve().summary["load_factor"]["carried"]
        expect(f"{strengths}: {factor}", abs(factor - min(strengths / above)) < 1e-7)


def check_loads():
    """Body forces and forces on blocks, as by expressions, and in load cases."""
    scene = voussoir.Scene(settings=dict(WALL, **{"Friction/Strength": 10, "Rotations": True}))
    n = scene.n_blocks
    weights = np.stack([np.linspace(0, 0.1, n), -1 - np.arange(n) / 7], axis=1)
    weights[2] = 0
    scene["Loads/Body force"] = weights
    found = scene.solve()
    expect("weights", np.allclose(found.loads, weights * found.areas[:, None], atol=1e-15) and
           np.allclose(found.load_torque, 0., atol=1e-12))
    scene["Loads/Body force"] = "0; 0"
    scene["Loads/Cell forces"] = weights * scene.areas[:, None]
    by_forces = scene.solve()
    expect("forces", np.allclose(by_forces.loads, found.loads, atol=1e-15))
    scene["Loads/Body force"] = np.array([[0., -1.]] * n)
    expect("both", np.allclose(scene.solve().loads, found.loads +
                               found.areas[:, None] * [0., -1.], atol=1e-15))
    # The columns may be anywhere in memory.
    scene["Loads/Body force"] = np.asfortranarray(weights)[::-1]
    scene["Loads/Cell forces"] = ""
    expect("rows", np.allclose(scene.solve().loads, weights[::-1] * found.areas[:, None],
                               atol=1e-15))
    scene = voussoir.Scene(text="subsection Load cases\n subsection wind\n end\nend\n",
                           settings=dict(WALL, **{"Loads/Combination": "2 wind",
                                                  "Load cases/wind/Cell forces": 0.01 * weights}))
    expect("a case", np.allclose(scene.solve().loads,
                                 0.02 * weights + scene.areas[:, None] * [0., -1.], atol=1e-15))


def check_space():
    """Of blocks in space rows have three columns."""
    scene = voussoir.Scene(polyhedra=TOWER, settings={
        "Rotations": True, "Supports/Where": "z < 1e-9", "Friction/Law": "associated Coulomb"})
    weights = np.array([[0, 0, -3], [0.1, 0, -2], [0, 0, -1]], float)
    scene["Loads/Body force"] = weights
    scene["Friction/Coefficient"] = np.array([0.5, 0.6, 0.7])
    found = scene.solve()
    expect("loads", np.allclose(found.loads, weights) and found.status == "solved")
    expect("coefficients", np.array_equal(found.coefficient, [0.5, 0.6, 0.7]))
    expect("joints", scene.n_joints == 3 and scene.n_blocks == 3)
    scene["Loads/Cell forces"] = weights
    expect("forces", np.allclose(scene.solve().loads, 2 * weights))
    raised(ValueError, "'Loads/Body force' takes an array of shape (n, 3) with a row for each of "
           "the n blocks that move, and this one has the shape (3, 2).",
           lambda: scene.set("Loads/Body force", weights[:, :2]))


def check_files():
    """A list stands in parameters.prm, with all digits."""
    scene = voussoir.Scene(settings=WALL)
    scene["Friction/Strength"] = 1 + np.random.default_rng(1).random(scene.n_joints)
    scene["Loads/Body force"] = -np.random.default_rng(2).random((scene.n_blocks, 2)) * [0.01, 1]
    found = scene.solve()
    found.write("lists")
    expect("run", run_program("lists/parameters.prm", "again") == 0)
    joints = table("again/interfaces.csv")
    for column, of in (("strength", found.strength), ("normal_force", found.normal_force),
                       ("tangential_force", found.tangential_force)):
        expect(column, np.array_equal(numbers(joints[column]), of))
    # A page does not show all of a long list.
    wide = voussoir.Scene(settings=dict(WALL, **{"Packing/wall/Courses": 30}))
    wide["Friction/Strength"] = 10 + np.random.default_rng(3).random(wide.n_joints)
    wide.solve().report("list.html")
    with open("list.html") as page:
        expect("a list on a page", "... (all in parameters.prm)" in page.read())


def check_numbers():
    """Numbers of numpy's are numbers."""
    scene = voussoir.Scene(settings=dict(WALL, **{"Rotations": np.bool_(True),
                                                  "Friction/Strength": np.float64(0.1)}))
    expect("as texts", scene["Rotations"] == "true" and scene["Friction/Strength"] == "0.1")
    scene["Friction/Strength"] = np.array(3)
    expect("no dimension", scene["Friction/Strength"] == "3")


def check_errors():
    """What is wrong with an array is told in exact words, and nothing is lost by it."""
    scene = voussoir.Scene(settings=WALL)
    n, m = scene.n_joints, scene.n_blocks
    joints = "takes an array of shape (n) with a number for each of the n joints, and this one "
    raised(ValueError, f"'Friction/Strength' {joints}has the shape (2, 2).",
           lambda: scene.set("Friction/Strength", np.ones((2, 2))))
    raised(ValueError, f"'Friction/Strength' {joints}has no real numbers.",
           lambda: scene.set("Friction/Strength", np.ones(n, complex)))
    raised(ValueError, f"'Friction/Strength' {joints}has no real numbers.",
           lambda: voussoir.Scene(settings={"Friction/Strength": np.array(["1"])}))
    raised(ValueError, "'Loads/Body force' takes an array of shape (n, 2) with a row for each of "
           f"the n blocks that move, and this one has the shape ({m},).",
           lambda: scene.set("Loads/Body force", np.ones(m)))
    raised(ValueError, "'Packing/wall/Courses' takes no array; the entries that do are named "
           "'Body force', 'Cell forces', 'Coefficient', 'Cohesion', 'Compressive strength', "
           "'Friction angle', 'Strength', 'Tensile strength'.",
           lambda: scene.set("Packing/wall/Courses", np.ones(2)))
    expect("as before", scene.solve().status == "solved")
    for entry, value, message in (
            ("Friction/Strength", np.ones(3),
             f"The parameter 'Friction/Strength' lists 3 numbers, but there are {n} interfaces; "
             "give one for each interface, in the order of their numbers."),
            ("Friction/Strength", np.ones(0),
             f"The parameter 'Friction/Strength' lists 0 numbers, but there are {n} interfaces; "
             "give one for each interface, in the order of their numbers."),
            ("Friction/Strength", np.where(np.arange(n) == 1, -2., 1.),
             "The parameter 'Friction/Strength' lists -2 for interface 1, on the interface of "
             "{one} and {two}; a strength must be finite and not negative."),
            ("Friction/Strength", np.where(np.arange(n) == 1, np.nan, 1.),
             "The parameter 'Friction/Strength' lists not a number for interface 1, on the "
             "interface of {one} and {two}; a strength must be finite and not negative."),
            ("Friction/Strength", np.where(np.arange(n) == 1, np.inf, 1.),
             "The parameter 'Friction/Strength' lists inf for interface 1, on the interface of "
             "{one} and {two}; a strength must be finite and not negative."),
            ("Contact/Compressive strength", np.where(np.arange(n) == 1, 0., 1.),
             "The parameter 'Contact/Compressive strength' lists 0 for interface 1, on the "
             "interface of {one} and {two}; a compressive strength must be finite and positive."),
            ("Loads/Body force", np.ones((m - 1, 2)),
             f"The parameter 'Loads/Body force' lists {m - 1} numbers, but there are {m} cells; "
             "give one for each cell, in the order of their numbers."),
            ("Loads/Cell forces", np.full((m, 2), np.nan),
             "The parameter 'Loads/Cell forces' lists not a number for cell 0; a force must be "
             "finite."),
            ("Loads/Cell forces", "list 1, 2",
             "The parameter 'Loads/Cell forces' has 1 list; 2 are expected, one for each "
             "component, with semicolons between."),
            ("Loads/Body force", "list 1, 2; 0",
             "The parameter 'Loads/Body force' has a list for some components only; give one for "
             "each, or expressions."),
            ("Loads/Body force", "0; list 1, 2",
             "The parameter 'Loads/Body force' has a list for some components only; give one for "
             "each, or expressions."),
            ("Friction/Strength", "list 1, two",
             "The parameter 'Friction/Strength' has 'two' where number 1 of its list is expected, "
             "counted from 0; a list has numbers with commas between, as in \"list 0.5, 0.6\".")):
        faulty = voussoir.Scene(settings=dict(WALL, **{entry: value}))
        one, two = (f"cell {of[1]}"
                    for of in (faulty.cell_minus, faulty.cell_plus))
        raised(voussoir.InputError, message.format(one=one, two=two), faulty.solve)


check_joints()
check_laws()
check_loads()
check_space()
check_files()
check_numbers()
check_errors()
print("OK")
