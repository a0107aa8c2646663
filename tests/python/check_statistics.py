"""Statistics of forces: closed forms, and the same by loops.

    python3 check_statistics.py SOURCE_DIRECTORY PROGRAM
"""
import itertools

import numpy as np
import voussoir
from checks import SOURCE, expect
from voussoir import statistics

STRESS = np.array([[-2., 0.5], [0.5, -1.]])


def raises(kind, message, action):
    try:
        action()
    except kind as error:
        return expect(f"{error!r} instead of {message!r}", str(error) == message)
    expect(f"{message}: nothing was raised", False)


def grid(columns, rows):
    return [np.array([[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]], float)
            for j in range(rows) for i in range(columns)]


def hexagons(columns, rows):
    """Regular hexagons with two vertical sides, in rows that are shifted in turn."""
    corners = np.array([[np.sin(k * np.pi / 3), -np.cos(k * np.pi / 3)] for k in range(6)])[::-1]
    corners = corners[::-1] if cross_area(corners) < 0 else corners
    return [corners + [np.sqrt(3) * (i + 0.5 * (j % 2)), 1.5 * j]
            for j in range(rows) for i in range(columns)]


def cross_area(corners):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(corners, np.roll(corners, -1, axis=0)))


def under_stress(polygons=(), stress=STRESS, **settings):
    """A packing without supports under a uniform stress on all of its boundary."""
    return voussoir.Scene(polygons=list(polygons), settings={
        "Loads/Boundary load": "uniform stress",
        "Loads/Stress": "; ".join(", ".join(map(repr, row)) for row in stress.tolist()),
        "Friction/Strength": 10, "Formulation": "least energy",
        **{name.replace("__", "/").replace("_", " "): value for name, value in settings.items()}})


def tower(n, at=0.):
    return [np.array([[at, k], [at + 1, k], [at + 1, k + 1], [at, k + 1]], float)
            for k in range(n)]


STANDING = {"Supports/Where": "y < 1e-9", "Loads/Body force": "0; -1", "Friction/Strength": 100,
            "Formulation": "least energy"}


def check_fabric():
    """Of a grid and of hexagons the directions of joints are known, and how many have each."""
    for columns, rows in ((2, 1), (1, 2), (3, 3), (4, 2)):
        found = under_stress(grid(columns, rows)).solve()
        across, up = (columns - 1) * rows, columns * (rows - 1)
        fabric = statistics.fabric(found)
        expect("a grid", np.allclose(fabric.tensor, np.diag([across, up]) / (across + up)))
        expect("its deviator", abs(fabric.deviator - abs(across - up) / (across + up)) < 1e-14)
        if across != up:
            expect("its angle", abs(fabric.angle - (0. if across > up else np.pi / 2)) < 1e-14)
    found = under_stress(hexagons(3, 3)).solve()
    directions = np.radians([0., 60., 120.])
    counts = [np.isclose(np.abs(found.normals @ [np.cos(a), np.sin(a)]), 1.).sum()
              for a in directions]
    expect(f"{counts} joints of hexagons", counts == [6, 5, 5])
    fabric = statistics.fabric(found)
    # sum of k n (x) n: 1/2 + the deviator (1/2)(cos 2a, sin 2a).
    cosine = np.dot(counts, np.cos(2 * directions)) / 16
    sine = np.dot(counts, np.sin(2 * directions)) / 16
    expect("hexagons", np.allclose(
        fabric.tensor, [[(1 + cosine) / 2, sine / 2], [sine / 2, (1 - cosine) / 2]]) and
        abs(fabric.deviator - np.hypot(cosine, sine)) < 1e-14 and min(
            fabric.angle, np.pi - fabric.angle) < 1e-7)
    # One of each direction is isotropic.
    one_each = [np.flatnonzero(np.isclose(np.abs(found.normals @ [np.cos(a), np.sin(a)]), 1.))[0]
                for a in directions]
    isotropic = statistics.fabric(found, np.isin(np.arange(found.n_joints), one_each))
    expect("isotropic", np.allclose(isotropic.tensor, np.eye(2) / 2) and isotropic.deviator < 1e-14)
    raises(ValueError, "weights has the shape (2,), and there are 16 joints; give a number for "
           "each", lambda: statistics.fabric(found, [1., 2.]))
    raises(ValueError, "weights must be finite and not negative, and not all be zero",
           lambda: statistics.fabric(found, -np.ones(16)))
    # The hydrostatic pressure of hexagons presses all joints alike.
    found = under_stress(hexagons(3, 3), -np.eye(2)).solve()
    expect("weighed by forces", np.allclose(statistics.force_fabric(found).tensor,
                                            statistics.fabric(found).tensor, atol=1e-8))


def check_distribution():
    """Of a tower the forces are 1, 2, ... weights."""
    found = voussoir.Scene(polygons=tower(3), settings=STANDING).solve()
    density, edges = statistics.force_distribution(found, [0., 0.75, 1.25, 2.])
    expect("three forces", np.allclose(density, [1 / 3 / 0.75, 1 / 3 / 0.5, 1 / 3 / 0.75]) and
           np.array_equal(edges, [0., 0.75, 1.25, 2.]))
    found = voussoir.Scene(polygons=tower(40), settings=STANDING).solve()
    for part in ("normal", "total"):
        density, edges = statistics.force_distribution(found, 7, part)
        forces = np.arange(1, 41) / 20.5
        for k in range(7):
            inside = [f for f in forces if edges[k] - 1e-9 < f < edges[k + 1] + (k == 6) * 1e-9]
            expect("a bin", abs(density[k] * (edges[k + 1] - edges[k]) - len(inside) / 40) < 1e-9)
    raises(ValueError, "there are no tangential forces to be distributed",
           lambda: statistics.force_distribution(found, part="tangential"))
    raises(ValueError, "part is 'shear'; 'normal', 'tangential' or 'total' are parts",
           lambda: statistics.force_distribution(found, part="shear"))
    found = random_packing().solve()
    for part, sizes in (("normal", -found.normal_force[found.normal_force < -1e-9]),
                        ("tangential", np.abs(found.tangential_force)),
                        ("total", np.hypot(found.normal_force, found.tangential_force))):
        density, edges = statistics.force_distribution(found, 10, part)
        expect(part, abs((density * np.diff(edges)).sum() - 1) < 1e-12 and
               np.isclose(edges[-1], sizes.max() / sizes.mean()))


def random_packing(**settings):
    scene = voussoir.Scene(f"{SOURCE}/prm/homogeneous_compression.prm", settings={
        "Loads/Boundary load": "uniform stress", "Loads/Stress": "-2, 0.5; 0.5, -1",
        "Formulation": "least energy"})
    for name, value in settings.items():
        scene[name.replace("__", "/").replace("_", " ")] = value
    return scene


def check_chains():
    """The strong joints of towers, which the ground does not connect."""
    found = voussoir.Scene(polygons=tower(4) + tower(4, 3.), settings=STANDING).solve()
    chains = statistics.chains(found)  # forces 1 to 4, so 3 and 4 are strong
    expect("two towers", len(chains) == 2)
    for chain in chains:
        first = chain.blocks[0]
        expect("a chain", np.allclose(sorted(-found.normal_force[chain.joints]), [3, 4]) and
               list(chain.blocks) == [first, first + 1] and first in (0, 4) and
               abs(chain.length - 1.5) < 1e-12)
    expect("all", [len(c.joints) for c in statistics.chains(found, 0.)] == [4, 4])
    expect("none", statistics.chains(found, 2.) == [])
    # By the closure of a relation, in random packings.
    for threshold in (0.5, 1., 1.5):
        found = random_packing().solve()
        sizes = np.hypot(found.normal_force, found.tangential_force)
        strong = np.flatnonzero(sizes > threshold * sizes.mean())
        blocks = [{int(found.cell_minus[e]), int(found.cell_plus[e])} - {-1} for e in strong]
        joined = np.array([[bool(a & b) for a in blocks] for b in blocks])
        for k in range(len(strong)):
            joined |= np.outer(joined[:, k], joined[k])
        expected = {tuple(strong[row]) for row in joined}
        chains = statistics.chains(found, threshold)
        expect(f"{len(chains)} chains", {tuple(c.joints) for c in chains} == expected)
        expect("their order", [len(c.joints) for c in chains] == sorted(
            (len(of) for of in expected), reverse=True))
        for chain in chains:
            touched = set(found.cell_minus[chain.joints]) | set(found.cell_plus[chain.joints])
            expect("blocks", set(chain.blocks) == touched - {-1})
            expect("length", abs(chain.length - sum(
                np.linalg.norm(found.branch[e]) for e in chain.joints)) < 1e-12)


def by_loops(found):
    """The mean of the stresses of blocks, each from the forces on its own sides."""
    moment = np.zeros((2, 2))
    for e, (minus, plus) in enumerate(zip(found.cell_minus, found.cell_plus)):
        middle = (found.starts[e] + found.ends[e]) / 2
        for i, j in itertools.product(range(2), range(2)):
            force = found.force[e, i]
            moment[i, j] += force * (middle - found.centres[minus])[j]
            if plus >= 0:
                moment[i, j] -= force * (middle - found.centres[plus])[j]
    for b, c in enumerate(found.boundary_cells):
        middle = (found.boundary_starts[b] + found.boundary_ends[b]) / 2
        moment += np.outer(found.boundary_forces[b], middle - found.centres[c])
    return moment / found.areas.sum()


def mean_of_blocks(found):
    return np.einsum("c,cij->ij", found.areas, found.stress) / found.areas.sum()


def check_mean_stress():
    """A uniform stress on the boundary is the mean stress, whatever the forces are."""
    for settings in ({}, {"Rotations": True}, {"Formulation": "linear program"},
                     {"Rotations": True, "Friction/Law": "associated Coulomb",
                      "Friction/Coefficient": 0.9}):
        scene = random_packing()
        for name, value in settings.items():
            scene[name] = value
        found = scene.solve()
        stress = statistics.mean_stress(found)
        expect(f"{settings}: {stress}", np.abs(stress - STRESS).max() < 1e-10)
        expect("symmetric", abs(stress[0, 1] - stress[1, 0]) < 1e-10)
        expect("of blocks", np.allclose(stress, mean_of_blocks(found), atol=1e-12))
        expect("by loops", np.allclose(stress, by_loops(found), atol=1e-12))
    # On supports, with a pressure that varies, and ties: as the blocks have it.
    for file, settings in (("semicircular_arch", {}), ("retaining_wall", {}), ("shear_wall", {}),
                           ("tied_arch", {}), ("spreading_arch", {}), ("dry_arch", {})):
        found = voussoir.Scene(f"{SOURCE}/prm/{file}.prm", settings=settings).solve()
        stress, of_blocks = statistics.mean_stress(found), mean_of_blocks(found)
        size = np.abs(of_blocks).max()
        expect(f"{file}: {stress} and {of_blocks}",
               np.abs(stress - of_blocks).max() < 1e-10 * size)
        if found.summary.get("rotations") or len(found.end_forces):
            expect(f"{file}: symmetric", abs(stress[0, 1] - stress[1, 0]) < 1e-8 * size)


def check_space():
    """The same of blocks in space."""
    stress = np.array([[-2., 0.3, 0.], [0.3, -1.5, 0.2], [0., 0.2, -1.]])
    for rotations in (False, True):
        found = voussoir.Scene(settings={
            "Dimension": 3, "Packing/Generator": "Voronoi", "Packing/Voronoi/Number of points": 25,
            "Rotations": rotations, "Loads/Boundary load": "uniform stress",
            "Loads/Stress": "; ".join(", ".join(map(repr, row)) for row in stress.tolist()),
            "Friction/Strength": 10}).solve()
        expect("in space", np.abs(statistics.mean_stress(found) - stress).max() < 1e-8)
        expect("faces", np.allclose(found.boundary_forces, found.boundary_areas[:, None] *
                                    (found.boundary_normals @ stress)))
    file = f"{SOURCE}/prm/space/building.prm"
    found = voussoir.Scene(file).solve()
    moves = ~found.fixed
    of_blocks = np.einsum("c,cij->ij", found.volumes[moves],
                          found.mean_stress[moves]) / found.volumes[moves].sum()
    mean = statistics.mean_stress(found)
    expect(f"{mean} and {of_blocks}", np.abs(mean - of_blocks).max() < 1e-9 * np.abs(mean).max())
    fabric = statistics.fabric(found)
    tensor = sum(np.outer(n, n) for n in found.normals) / found.n_joints
    values = np.linalg.eigvalsh(tensor)
    expect("fabric", np.allclose(fabric.tensor, tensor) and abs(
        fabric.deviator - np.sqrt(1.5 * ((values - 1 / 3)**2).sum())) < 1e-14)
    sizes = np.hypot(found.normal_force, np.linalg.norm(found.shear_force, axis=1))
    strong = set(np.flatnonzero(sizes > sizes[sizes > 1e-12 * sizes.max()].mean()))
    chains = statistics.chains(found)
    expect("chains", sorted(e for chain in chains for e in chain.joints) == sorted(strong))
    density, edges = statistics.force_distribution(found)
    expect("distribution", abs((density * np.diff(edges)).sum() - 1) < 1e-12)


check_fabric()
check_distribution()
check_chains()
check_mean_stress()
check_space()
print("OK")
