"""Structures in space, and the same in the plane: parameters of voussoir.

Lengths are in m, and forces in kN, per m in the plane.
"""
import itertools
import math

import numpy as np

SPACE = {"Dimension": 3}
COULOMB = {"Friction/Law": "associated Coulomb", "Friction/Coefficient": 0.65}
NO_STRESS = {"Accuracy": "draft", "Output/Report": "false",
             "Output/Verbosity": 0}
PUSHED_IN_PLANE = {"Loads/Body force": "0; -20",
                   "Live loads/Body force": "20; 0"}
PUSHED = {"Loads/Body force": "0; 0; -20", "Live loads/Body force": "20; 0; 0"}
ON_THE_GROUND = {"Supports/Where": "z < 1e-9 && nz < -0.5"}
THICKNESS = 0.25  # of what is extruded


def wall(courses, bricks):
    """A wall in running bond that is pushed in its plane, extruded."""
    return {**SPACE, "Rotations": "true", **COULOMB, **PUSHED, **ON_THE_GROUND,
            "Packing/Generator": "wall", "Packing/wall/Length": 0.5 * bricks,
            "Packing/wall/Height": 0.25 * courses,
            "Packing/wall/Thickness": THICKNESS,
            "Packing/wall/Brick length": 0.5,
            "Packing/wall/Brick width": THICKNESS,
            "Packing/wall/Brick height": 0.25}


def wall_in_plane(courses, bricks):
    """The same wall in the plane."""
    return {"Formulation": "least energy", "Rotations": "true", **COULOMB,
            **PUSHED_IN_PLANE, "Supports/Where": "y < 1e-9 && ny < -0.5",
            "Packing/Generator": "wall", "Packing/wall/Courses": courses,
            "Packing/wall/Bricks per course": bricks,
            "Packing/wall/Width": 0.5 * bricks,
            "Packing/wall/Height": 0.25 * courses}


def arch(voussoirs):
    """A semicircular arch that is pushed in its plane, extruded."""
    return {**SPACE, "Rotations": "true", **COULOMB, **PUSHED,
            "Supports/Where": "z < 1e-9 && nz < -0.99",
            "Packing/Generator": "vault", "Packing/vault/Voussoirs": voussoirs,
            "Packing/vault/Length": THICKNESS,
            "Packing/vault/Blocks per row": 1, "Packing/vault/Bond": "stack"}


def arch_in_plane(voussoirs):
    """The same arch in the plane."""
    return {"Formulation": "least energy", "Rotations": "true", **COULOMB,
            **PUSHED_IN_PLANE, "Supports/Where": "y < 1e-9",
            "Packing/Generator": "arch", "Packing/arch/Shape": "circular",
            "Packing/arch/Mean radius": 1, "Packing/arch/Thickness": 0.2,
            "Packing/arch/Voussoirs": voussoirs}


def dome(courses, sectors):
    """A hemispherical dome that is pushed sideways."""
    return {**SPACE, "Rotations": "true", **COULOMB, **PUSHED,
            "Supports/Where": "z < 1e-9 && nz < -0.5",
            "Packing/Generator": "dome", "Packing/dome/Thickness": 0.15,
            "Packing/dome/Courses": courses, "Packing/dome/Sectors": sectors}


def cohesive(scene, strength):
    """A structure whose joints have Tresca's strength instead."""
    return {**scene, "Friction/Law": "Tresca", "Friction/Strength": strength}


def twisted_column(drums, sides):
    """A column of drums under its weight that is twisted at its top."""
    return {**SPACE, "Rotations": "true", **ON_THE_GROUND,
            "Packing/Generator": "column", "Packing/column/Drums": drums,
            "Packing/column/Sides": sides, "Loads/Body force": "0; 0; -20",
            "Live loads/Traction": "z > 3.99 ? -y : 0; z > 3.99 ? x : 0; 0",
            "Friction/Law": "Tresca", "Friction/Strength": 8}


def wall_pushed_at_an_end(courses, bricks):
    """A wall that is pushed out of its plane at one end, so that beds twist;
    its joints have Tresca's strength."""
    return {**cohesive(wall(courses, bricks), 2),
            "Live loads/Body force": "0; 0; 0",
            "Live loads/Traction":
                f"0; x > {0.5 * bricks - 1e-9!r} ? 1 : 0; 0"}


def grains(cells, turning):
    """Voronoi cells in a cube under pressure, and a deviator as live load."""
    return {**SPACE, "Rotations": turning,
            "Packing/Generator": "Voronoi",
            "Packing/Voronoi/Number of points": cells,
            "Loads/Boundary load": "uniform stress",
            "Loads/Stress": "-1, 0, 0; 0, -1, 0; 0, 0, -1",
            "Live loads/Boundary load": "uniform stress",
            "Live loads/Stress": "-1, 0, 0; 0, 0.5, 0; 0, 0, 0.5",
            "Friction/Strength": 0.3}


def cube():
    """Vertices (n, 3) and faces, outwards, of the cube with the side 2."""
    vertices = np.array(list(itertools.product((-1., 1.), repeat=3)))
    return vertices, faces_of(vertices, np.vstack([np.eye(3), -np.eye(3)]))


def dodecahedron():
    """The same of the regular dodecahedron with the inradius one."""
    golden = (1 + math.sqrt(5)) / 2
    vertices = [*itertools.product((-1., 1.), repeat=3)]
    normals = []
    for a, b in itertools.product((-1., 1.), repeat=2):
        for shift in range(3):
            vertices.append(tuple(np.roll((0, a / golden, b * golden), shift)))
            normals.append(np.roll((0, a * golden, b), shift))
    vertices, normals = np.array(vertices), np.array(normals)
    return (vertices / (vertices @ normals[0]).max() * math.hypot(1, golden),
            faces_of(vertices, normals / math.hypot(1, golden)))


def faces_of(vertices, normals):
    """The faces with the given normals of a convex polyhedron: indices of
    vertices, anticlockwise from outside."""
    faces = []
    for normal in normals:
        height = vertices @ normal
        on = np.flatnonzero(height > height.max() - 1e-9)
        arm = vertices[on] - vertices[on].mean(axis=0)
        along = arm[0] / np.linalg.norm(arm[0])
        across = np.cross(normal, along)
        faces.append(on[np.argsort(np.arctan2(arm @ across, arm @ along))])
    return faces
