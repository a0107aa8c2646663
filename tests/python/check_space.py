"""The module of Python in space: its numbers, its memory, and its errors.

    python3 check_space.py SOURCE_DIRECTORY PROGRAM
"""
import csv
import gc
import subprocess
import sys

import numpy as np
import voussoir

from checks import PROGRAM, SOURCE, expect, raised

BOX = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
FACES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
TOWER = [(BOX + [0, 0, k], FACES) for k in range(3)]
STANDING = {"Rotations": True, "Supports/Where": "z < 1e-9", "Loads/Body force": "0; 0; -1",
            "Friction/Law": "associated Coulomb", "Friction/Coefficient": 0.5}


def column(file, name):
    with open(file, newline="") as lines:
        return np.array([float(r[name]) for r in csv.DictReader(lines)])


def check_like_the_program():
    """A scene has the numbers that the program writes."""
    file = f"{SOURCE}/prm/space/building.prm"
    subprocess.run([PROGRAM, file, "--quiet", "--set", "Output directory=building"], check=True)
    scene = voussoir.Scene(file)
    found = scene.solve()
    expect("classes", type(scene) is voussoir.SceneInSpace
           and type(found) is voussoir.ResultsInSpace and isinstance(scene, voussoir.Scene)
           and isinstance(found, voussoir.Results))
    expect("status", found.status == "solved" and not found.warnings)
    for name, of in (("cell_minus", found.cell_minus), ("cell_plus", found.cell_plus),
                     ("support", found.support), ("x", found.centroids[:, 0]),
                     ("nz", found.normals[:, 2]), ("area", found.areas),
                     ("distance", found.distance), ("normal_force", found.normal_force),
                     ("shear_force_y", found.shear_force[:, 1]), ("moment_z", found.moment[:, 2]),
                     ("eccentricity_x", found.eccentricity[:, 0]),
                     ("utilisation", found.utilisation), ("opening", found.opening),
                     ("sliding", found.sliding)):
        expect(name, np.array_equal(column("building/interfaces.csv", name), of))
    for name, of in (("z", found.centres[:, 2]), ("volume", found.volumes), ("fixed", found.fixed),
                     ("faces", found.faces), ("load_z", found.loads[:, 2]),
                     ("torque_x", found.load_torque[:, 0]),
                     ("displacement_x", found.displacement[:, 0]),
                     ("rotation_y", found.rotation[:, 1])):
        expect(name, np.array_equal(column("building/cells.csv", name), of))
    for name, of in (("interface", found.point_interface), ("pressure", found.point_pressure),
                     ("share", found.point_share), ("y", found.points[:, 1]),
                     ("force_z", found.point_forces[:, 2])):
        expect(name, np.array_equal(column("building/interface_points.csv", name), of))
    expect("help", type(found).normal_stress.__doc__ ==
           "with loads that are carried only: the normal force over |e|; S.")
    # The forces of the points are those of the interfaces.
    sums = np.zeros((len(found.areas), 3))
    np.add.at(sums, found.point_interface, found.point_forces)
    expect("sums", np.allclose((sums * found.normals).sum(axis=1), found.normal_force, atol=1e-9))
    expect("polygons", len(found.interface_polygons) == len(found.areas) and all(
        np.allclose(polygon.mean(axis=0), centroid) for polygon, centroid
        in zip(found.interface_polygons, found.centroids) if len(polygon) == 4))
    # Its polyhedra are the same packing again.
    again = voussoir.Scene(polyhedra=scene.polyhedra, settings={
        "Supports/Where": scene["Supports/Where"]})
    expect("again", np.allclose(again.volumes, scene.volumes)
           and len(again.centroids) == len(scene.centroids))


def check_polyhedra():
    """A tower of boxes of weight one, drawn by arrays."""
    scene = voussoir.Scene(polyhedra=TOWER, settings=STANDING)
    expect("the packing alone", np.allclose(scene.volumes, 1) and len(scene.areas) == 3
           and scene["Dimension"] == "3" and scene["Packing/Generator"] == "model")
    found = scene.solve()
    expect("forces", np.allclose(found.normal_force, [-2, -1, -3], atol=1e-12))
    expect("a summary", np.isclose(found.summary["packing"]["volume"], 3)
           and np.allclose(found.summary["force_on_ground"], [0, 0, -3]))
    scene["Loads/Body force"] = "0.4; 0; -1"
    pushed = scene.solve()
    expect("collapse", pushed.status == "collapse"
           and pushed.summary["mechanism"]["work_over_dissipation"] is None)
    expect("mechanism", np.abs(pushed.displacement).max() > 0 and pushed.opening.max() > 0)
    raised(AttributeError, "there is no 'normal_force': it is there with loads that are carried only",
           lambda: pushed.normal_force)
    scene["Loads/Body force"] = "0; 0; -1"
    scene["Live loads/Body force"] = "1; 0; 0"
    scene["Analysis"] = "load factor"
    factor = scene.solve().summary["load_factor"]
    expect("load factor", abs(factor["carried"] * 3 - 1) < 1e-8)
    # The packing is made again if it has to be, and else with its warnings.
    scene["Analysis"] = "state"
    scene["Supports/Where"] = "z > 3 - 1e-9"
    expect("hanging", scene.solve().status == "collapse")
    unloaded = voussoir.Scene(polyhedra=TOWER + [(BOX + [0.2, 0, 0.5], FACES)])
    for _ in range(2):
        found = unloaded.solve()
        expect("a packing", found.status == "packing" and "load_factor" not in found.summary)
        expect(found.warnings, len(found.warnings) == 1 and "penetrate" in found.warnings[0])
        expect("defects", found.summary["packing"]["defects"][0]["kind"] == 12)
    raised(AttributeError, "there is no 'loads': it is there with loads only",
           lambda: unloaded.solve().loads)


def check_errors():
    """What is wrong is told in exact words."""
    polyhedron = ("polyhedron 1 must be a pair: an array of its vertices, of shape (n, 3), and its "
                  "faces, lists of the numbers of vertices")
    raised(ValueError, polyhedron, lambda: voussoir.Scene(polyhedra=[1]))
    raised(ValueError, polyhedron, lambda: voussoir.Scene(polyhedra=[(BOX[:, :2], FACES)]))
    raised(ValueError, "polyhedron 2 has a face with the vertex 8, and its vertices are 0 to 7",
           lambda: voussoir.Scene(polyhedra=[TOWER[0], (BOX, [[0, 1, 8]])]))
    raised(voussoir.InputError,
           "'polygons' are blocks in the plane, and 'Dimension' is 3; give 'polyhedra'.",
           lambda: voussoir.Scene(polygons=[BOX[:4, :2]], settings={"Dimension": 3}))
    raised(voussoir.InputError,
           "'polyhedra' are blocks in space, and 'Dimension' is 2; give 'polygons'.",
           lambda: voussoir.Scene(polyhedra=TOWER, settings={"Dimension": 2}))
    in_space = voussoir.Scene(polyhedra=TOWER, settings=STANDING)
    raised(voussoir.InputError, "'Dimension' is 2, and this scene has been made with 3; make "
           "another one for it.", lambda: in_space.set("Dimension", 2))
    expect("as before", in_space["Dimension"] == "3" and in_space.solve().status == "solved")
    raised(voussoir.InputError, "'Dimension' is 3, and this scene has been made with 2; make "
           "another one for it.", lambda: voussoir.Scene().set("Dimension", 3))
    raised(KeyError, "there is no entry 'Friction/None'", lambda: in_space["Friction/None"])
    # A block without its bottom; the scene can be used after the error.
    try:
        voussoir.Scene(polyhedra=[(BOX, FACES[1:])]).solve()
        sys.exit("an open block: nothing was raised")
    except voussoir.InputError as error:
        expect(error, "'the arrays'" in str(error) and "polyhedron 1" in str(error))


def check_views():
    """Arrays show the memory of the results, and keep it."""
    found = voussoir.Scene(polyhedra=TOWER, settings=STANDING).solve()
    forces, normals = found.point_forces, found.normals
    expect("no copy", forces.ctypes.data == found.point_forces.ctypes.data)
    before = forces.copy(), normals.copy()
    try:
        normals[0] = 1.0
        sys.exit("normals: nothing was raised")
    except ValueError:
        pass
    del found
    gc.collect()
    expect("kept", np.array_equal(forces, before[0]) and np.array_equal(normals, before[1]))


check_like_the_program()
check_polyhedra()
check_errors()
check_views()
print("OK")
