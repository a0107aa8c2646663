"""The structures and the ways to solve them: parameters of voussoir."""
import math

WAYS = {
    "compliant": {"Formulation": "smoothed friction",
                  "Solver/smoothed friction/Contact": "compliant"},
    "hard": {"Formulation": "smoothed friction",
             "Solver/smoothed friction/Contact": "hard"},
    "linear program": {"Formulation": "linear program"},
    "least energy": {"Formulation": "least energy"},
    "centre (edge area)": {
        "Formulation": "analytic centre",
        "Solver/analytic centre/Barrier weights": "edge area"},
    "centre (equal)": {"Formulation": "analytic centre",
                       "Solver/analytic centre/Barrier weights": "equal"},
}
STRENGTH = 0.3  # s_T of all scenes but the shear wall, over the mean pressure
FORCES_ONLY = {"Accuracy": "draft", "Output/Files": "csv",
               "Output/Verbosity": 0}


def stress(deviator):
    """The uniform stress diag(-(1 + d), -(1 - d)) as text."""
    return f"{-1 - deviator!r}, 0; 0, {-1 + deviator!r}"


def under_stress(deviator):
    """The load of stress(deviator) with the strength 0.3."""
    return {"Loads/Boundary load": "uniform stress",
            "Loads/Stress": stress(deviator), "Friction/Strength": STRENGTH}


def random_cells(cells, deviator):
    """Voronoi cells of random points in the unit square."""
    return {"Packing/Generator": "Voronoi",
            "Packing/Voronoi/Number of points": cells,
            **under_stress(deviator)}


def shear_wall(load, courses, bricks):
    """A wall in running bond under the shear `load`; the limit is 1."""
    return {"Packing/Generator": "wall",
            "Packing/wall/Courses": courses,
            "Packing/wall/Bricks per course": bricks,
            "Loads/Traction": f"{load!r}*ny; 0",
            "Friction/Strength": 1}


def turned_squares(deviator, side, directory):
    """Squares turned by 45 degrees, side^2 / 2 in number; the limit of the
    deviator is the strength."""
    points = directory / "turned_squares.txt"
    points.write_text("".join(
        f"{(i + 0.5) / side!r} {(j + 0.5) / side!r}\n"
        for i in range(side) for j in range(side) if (i + j) % 2 == 0))
    return {"Packing/Generator": "Voronoi",
            "Packing/Voronoi/Points": "file",
            "Packing/Voronoi/Points file": points,
            **under_stress(deviator)}


def wall_under_weight(courses, bricks):
    """A wall in running bond on the ground, under its weight of 1 in all."""
    return {"Packing/Generator": "wall",
            "Packing/wall/Courses": courses,
            "Packing/wall/Bricks per course": bricks,
            "Supports/Where": "y < 1e-9", "Loads/Body force": "0; -1",
            "Friction/Strength": STRENGTH}


def regular_polygon(sides, traction, directory):
    """One regular block of inradius 1 under a traction on all its sides, the
    first of which has the normal (1, 0)."""
    radius = 1 / math.cos(math.pi / sides)
    corners = [(radius * math.cos((2 * k - 1) * math.pi / sides),
                radius * math.sin((2 * k - 1) * math.pi / sides))
               for k in range(sides)]
    text = ", ".join(f"{x!r} {y!r}" for x, y in corners + corners[:1])
    file = directory / f"polygon_{sides}.wkt"
    file.write_text(f"POLYGON (({text}))\n")
    return {"Packing/Generator": "polygons", "Packing/polygons/File": file,
            "Loads/Traction": traction}


# Tractions whose forces add up to zero on every regular polygon. The uneven one
# has the modes cos(2 theta) of the angle theta of the normal, in x alone, and
# no torque; in a triangle every traction without torque is that of a uniform
# stress.
TRACTIONS = {
    "uniform stress": "-1.3*nx + 0.2*ny; 0.2*nx - 0.7*ny",
    "uneven, no torque": "-nx + 0.5*(nx*nx - ny*ny); -ny",
    "uneven, torque":
        "-nx + 0.5*(nx*nx - ny*ny) - 0.5*ny; -ny + 0.5*nx",
}
UNIFORM_STRESS = ((-1.3, 0.2), (0.2, -0.7))
