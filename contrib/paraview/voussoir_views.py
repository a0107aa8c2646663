"""The views of render.py: what of a result is drawn, as layers of lines and
polygons in the coordinates of the packing."""
import csv
import json
import os
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Callable

import numpy as np
from vtkmodules.vtkIOXML import (
    vtkXMLPUnstructuredGridReader, vtkXMLUnstructuredGridReader)

import macro
from macro import (DIVERGING, SEQUENTIAL, Grid, Polyhedra, chains, crosses, resultants,
                   ribbons, thrust)

# From 0 to 1, for the sizes of stresses that all have one sign.
ONE_SIGN = [(0, 0.98, 0.95, 0.80), (0.35, 0.91, 0.66, 0.30), (0.7, 0.64, 0.22, 0.30),
            (1, 0.20, 0.07, 0.28)]
# Of |eccentricity| times 2: blue in the middle third of a joint, warm outside it.
MIDDLE_THIRD = [(0, 0.72, 0.83, 0.93), (1 / 3, 0.30, 0.55, 0.80),
                (1 / 3 + 1e-6, 0.99, 0.80, 0.40), (1, 0.66, 0.07, 0.12)]
GROUPS = np.array(macro.GROUPS)
COMPRESSION, TENSION = DIVERGING[0][1:], DIVERGING[-1][1:]
PALE, GREY, DARK = (0.96, 0.96, 0.96), (0.55, 0.55, 0.55), (0.15, 0.15, 0.15)
RED = (0.75, 0.16, 0.08)
# Less than this part of the largest stress or force of a result is rounding.
ROUNDING = 1e-9
# At a hinge one end of a joint opens, by more than this part of the largest opening,
# and the other does not, or by less than this part of that.
SHUT = 1e-2


class NotThere(Exception):
    """What was asked for is not in the results; the message is for the user."""


def interpolate(scale, values):
    at, *rgb = np.array(scale).T
    return np.column_stack([np.interp(values, at, channel) for channel in rgb])


class Results:
    """The files of a result directory."""

    def __init__(self, directory):
        self.directory = directory
        if not os.path.isdir(directory):
            raise NotThere(f"There is no directory '{directory}'.")
        try:
            with open(os.path.join(directory, "summary.json")) as file:
                self.summary = json.load(file)
        except (OSError, ValueError):
            raise NotThere(f"'{directory}' holds no results of voussoir: it has "
                           "no summary.json that can be read.") from None

    def has(self, name):
        return os.path.exists(os.path.join(self.directory, name))

    def in_space(self):
        return self.summary.get("dimension") == 3

    def read(self, name):
        """An unstructured grid of VTK."""
        reader = (vtkXMLPUnstructuredGridReader if name.endswith(".pvtu")
                  else vtkXMLUnstructuredGridReader)()
        file = os.path.join(self.directory, name)
        reader.SetFileName(file)
        if not self.has(name) or not reader.CanReadFile(file):
            raise NotThere(f"'{self.directory}' has no {name} that can be read; "
                           f"its status is '{self.summary.get('status')}'.")
        reader.Update()
        return reader.GetOutput()

    @lru_cache(maxsize=None)
    def grid(self, name):
        return Grid(self.read(name))

    def blocks(self):
        return self.grid("blocks.vtu")

    @lru_cache(maxsize=None)
    def polyhedra(self):
        return Polyhedra(self.read("blocks.vtu"))

    def stress(self):
        """The sub-cells, or the blocks of a run without them (Accuracy = draft)."""
        for name in ("stress.vtu", "stress.pvtu"):
            if self.has(name):
                return self.grid(name)
        return self.blocks()

    def interfaces(self):
        return self.grid("interfaces.vtu")

    def mechanism(self):
        return self.grid("mechanism.vtu")

    @lru_cache(maxsize=None)
    def hinges(self):
        """Of a mechanism of blocks that turn: the corners about which they do.

        That is the end of a joint that stays shut while the other opens."""
        if not (self.summary.get("rotations") and self.has("mechanism_joints.csv")):
            return np.empty(0, int)
        with open(os.path.join(self.directory, "mechanism_joints.csv")) as file:
            joints = list(csv.DictReader(file))
        opening = np.array([[float(joint[f"opening_{end}"]) for end in (0, 1)]
                            for joint in joints]).reshape(-1, 2)
        smaller, larger = np.sort(opening).T
        hinged = (larger > SHUT * larger.max(initial=0)) & (smaller < SHUT * larger)
        return np.array([corner_of(self.mechanism(), joints[i], opening[i].argmin())
                         for i in np.flatnonzero(hinged)], int)

    def title(self):
        """The selection, in a few words."""
        selection = self.summary.get("selection", "").split(":")[0]
        if selection.startswith("analytic centre"):
            equal = "equal weights" in selection
            return "analytic centre, " + ("equal" if equal else "edge area")
        return selection

    def groups(self):
        return [group["name"] for group in self.summary["packing"]["groups"]]


@dataclass
class Layer:
    """Polygons, or lines whose width is that of outlines times line_width.

    A third coordinate of points is how near they are to the viewer."""
    points: np.ndarray
    offsets: np.ndarray
    corners: np.ndarray
    colours: object
    line_width: float = 0


class Panel:
    """A result in a view: its layers, from the lowest to the topmost, that of the
    blocks among them."""

    def __init__(self, blocks, *layers):
        self.n_blocks, self.layers = blocks.size, layers

    def bounds(self):
        """The lower left and the upper right corner."""
        points = np.concatenate([layer.points[:, :2] for layer in self.layers])
        return points.min(axis=0), points.max(axis=0)


def fill(grid, colours, points=None):
    return Layer(grid.points if points is None else points, grid.offsets,
                 grid.corners, colours)


def outline(grid, points=None, colour=DARK, width=1):
    """Each polygon as a line that returns to its first point."""
    first, end = grid.offsets[:-1], grid.offsets[1:]
    closed = np.insert(grid.corners, end, grid.corners[first])
    return Layer(grid.points if points is None else points,
                 grid.offsets + np.arange(len(grid.offsets)), closed, colour, width)


def marks(begin, end, width, colours):
    corners = np.arange(4 * len(begin))
    return Layer(ribbons(begin, end, width), np.arange(0, len(corners) + 1, 4),
                 corners, colours)


def arrows(begin, end, head, colour):
    """Shafts and heads, whose sizes are a number for each arrow."""
    along = end - begin
    length = np.hypot(*along.T)
    along /= np.where(length > 0, length, 1)[:, None]
    across = np.column_stack((-along[:, 1], along[:, 0]))
    neck = end - head[:, None] * along
    side = 0.4 * head[:, None] * across
    corners = np.stack((end, neck + side, neck - side), axis=1).reshape(-1, 2)
    return (marks(begin, neck, 0.2 * head, colour),
            Layer(corners, np.arange(0, len(corners) + 1, 3), np.arange(len(corners)),
                  colour))


def discs(middles, radius, colour):
    """Polygons of 24 sides."""
    angle = np.arange(24) * np.pi / 12
    circle = radius * np.column_stack((np.cos(angle), np.sin(angle)))
    points = (middles[:, None] + circle).reshape(-1, 2)
    return Layer(points, np.arange(0, len(points) + 1, 24), np.arange(len(points)),
                 colour)


def corner_of(grid, joint, end):
    """The corner of c- that is a shut end of a joint, given by its line of the table.

    The joint is a side of c-, as its length and direction say. Several sides may be
    alike, pieces of a straight one: the corner is the one at which c+ stays."""
    minus, plus = int(joint["cell_minus"]), int(joint["cell_plus"])
    normal = np.array([float(joint["nx"]), float(joint["ny"])])
    vector = float(joint["length"]) * np.array([-normal[1], normal[0]])
    points, motion = grid.points, grid.of_points["displacement"][:, :2]
    start = grid.corners[grid.offsets[minus]:grid.offsets[minus + 1]]
    side = np.column_stack((start, np.roll(start, -1)))
    off = np.hypot(*(points[side[:, 1]] - points[start] - vector).T)
    corner = side[off < 1e-6 * np.hypot(*vector), end]
    opening = motion[corner] @ normal
    if plus >= 0:
        others = grid.corners[grid.offsets[plus]:grid.offsets[plus + 1]]
        same = (points[corner][:, None] == points[others]).all(axis=2)
        opening -= motion[others[same.argmax(axis=1)]] @ normal
        opening[~same.any(axis=1)] = np.inf
    return corner[np.abs(opening).argmin()]


def component(name, grid):
    """sigma_xx and its like, or a scalar."""
    index = {"sigma_xx": 0, "sigma_xy": 1, "sigma_yy": 4}.get(name)
    return (grid.of_cells[name] if index is None
            else grid.of_cells["stress"][:, index])


def principal_grid(results, options):
    return results.stress() if options.sub_cells else results.blocks()


def forces(results):
    cells = results.interfaces().of_cells
    return np.concatenate((cells["normal_force"], cells["tangential_force"]))


def magnitude(grid):
    """Of the displacement, of each block."""
    vector = grid.of_points["displacement"][grid.corners[grid.offsets[:-1]]]
    return np.hypot(vector[:, 0], vector[:, 1])


def block_size(grid):
    return np.sqrt(np.abs(grid.areas_and_centroids()[0]).mean())


def scale_of(low, high):
    """The colours of stresses between two values, and what these have to be divided
    by besides the limit: -1 where all are compression."""
    if min(-low, high) >= ROUNDING * max(-low, high):
        return DIVERGING, 1
    return ONE_SIGN, 1 if high > -low else -1


def stress_panel(name, results, limit, options):
    grid, blocks = results.stress(), results.blocks()
    scale, sign = options.colours
    values = component(name, grid) / (sign * limit)
    return Panel(blocks, fill(grid, interpolate(scale, values)), outline(blocks))


def on_pale_blocks(blocks, *layers, width=0.7):
    return Panel(blocks, fill(blocks, PALE), outline(blocks, colour=GREY, width=width),
                 *layers)


def ends_of(interfaces):
    """The start and the end of each, (n, 2, 2)."""
    return interfaces.points[interfaces.corners.reshape(-1, 2)]


def mark_colours(value):
    return np.where(value[:, None] < 0, COMPRESSION, TENSION)


def principal_panel(results, limit, options):
    blocks = results.blocks()
    *lines, value = crosses(principal_grid(results, options), limit)
    return on_pale_blocks(blocks, marks(*lines, mark_colours(value)), width=1)


def chain_panel(results, limit, options):
    blocks = results.blocks()
    *lines, value = chains(blocks, results.interfaces(), limit)
    return on_pale_blocks(blocks, marks(*lines, mark_colours(value)), width=1)


def thrust_panel(results, limit, options):
    blocks = results.blocks()
    *lines, value = thrust(blocks, results.interfaces(), limit)
    return on_pale_blocks(blocks, marks(*lines, COMPRESSION))


def resultant_values(results, options=None):
    return np.hypot(*results.interfaces().of_cells["force"][:, :2].T)


def resultant_panel(results, limit, options):
    """On each joint, where the resultant acts, a line along it."""
    blocks, interfaces = results.blocks(), results.interfaces()
    ends = ends_of(interfaces)
    along = ends[:, 1] - ends[:, 0]
    place = interfaces.of_cells.get("eccentricity", np.zeros(interfaces.size))
    at = ends.mean(axis=1) + place[:, None] * along
    force = interfaces.of_cells["force"][:, :2] / limit
    size = block_size(blocks)
    share = resultant_values(results) / limit
    half = 0.5 * size * force / np.maximum(share, 1)[:, None]
    width = np.where(share > ROUNDING, size * 0.07, 0)
    return on_pale_blocks(blocks, marks(at - half, at + half, width, COMPRESSION))


@lru_cache(maxsize=None)
def applied_forces(results):
    """Where forces act, and what they are: of free sides at their middles, the rest
    of each block's at its centroid. Forces that are rounding are left out."""
    blocks = results.blocks()
    at, force = blocks.areas_and_centroids()[1], blocks.of_cells["load"][:, :2].copy()
    if results.has("boundary.csv"):
        with open(os.path.join(results.directory, "boundary.csv")) as file:
            sides = list(csv.DictReader(file))

        def columns(*names):
            return np.array([[float(side[name]) for name in names]
                             for side in sides]).reshape(-1, len(names))
        of_sides = columns("force_x", "force_y")
        np.subtract.at(force, columns("cell")[:, 0].astype(int), of_sides)
        at = np.concatenate((at, (columns("x0", "y0") + columns("x1", "y1")) / 2))
        force = np.concatenate((force, of_sides))
    size = np.hypot(*force.T)
    drawn = size > ROUNDING * size.max(initial=0)
    return at[drawn], force[drawn]


def load_values(results, options=None):
    return np.hypot(*applied_forces(results)[1].T)


def load_panel(results, limit, options):
    """Arrows that end where the forces act, and the joints with the ground."""
    blocks, interfaces = results.blocks(), results.interfaces()
    at, force = applied_forces(results)
    size, value = block_size(blocks), load_values(results)
    # The smallest can still be seen.
    length = size * (0.15 + 0.85 * np.minimum(1, value / limit))
    begin = at - (length / value)[:, None] * force
    ends = ends_of(interfaces)[interfaces.of_cells["cell_plus"] < 0]
    return on_pale_blocks(
        blocks, marks(ends[:, 0], ends[:, 1], np.full(len(ends), 0.12 * size), DARK),
        *arrows(begin, at, 0.1 * size + 0.25 * length, RED))


def joint_panel(blocks, interfaces, value, width, scale):
    """Joints in colours, those of the largest value on top."""
    order = np.argsort(value, kind="stable")
    begin, end = ends_of(interfaces)[order].swapaxes(0, 1)
    return on_pale_blocks(blocks, marks(begin, end, block_size(blocks) * width[order],
                                        interpolate(scale, value[order])))


def utilisation_panel(results, limit, options):
    interfaces = results.interfaces()
    value = interfaces.of_cells.get("utilisation", np.empty(0))
    width = np.where(value > 1 - 1e-6, 0.14, 0.07)
    return joint_panel(results.blocks(), interfaces, value, width, SEQUENTIAL)


def eccentricity_panel(results, limit, options):
    """Joints that nothing presses have no width."""
    interfaces = results.interfaces()
    value = 2 * np.abs(interfaces.of_cells["eccentricity"])
    width = np.zeros(len(value))
    width[resultants(interfaces)[0]] = 0.1
    return joint_panel(results.blocks(), interfaces, value, width, MIDDLE_THIRD)


def range_values(results, options=None):
    """How far the normal forces of all states differ; not of those left out."""
    of = results.interfaces().of_cells
    return (of["p_max"] - of["p_min"])[of["determined"] >= 0]


def range_panel(results, limit, options):
    """Joints without bound are wide, those left out have no width."""
    interfaces = results.interfaces()
    of = interfaces.of_cells
    value = np.clip((of["p_max"] - of["p_min"]) / limit, 0, 1)
    width = np.where(of["unbounded"] == 1, 0.14, 0.07)
    width[of["determined"] < 0] = 0
    value[of["unbounded"] == 1] = 1
    return joint_panel(results.blocks(), interfaces, value, width, SEQUENTIAL)


def group_panel(results, limit, options):
    blocks = results.blocks()
    return Panel(blocks, fill(blocks, GROUPS[blocks.of_cells["group"] % len(GROUPS)]),
                 outline(blocks))


def moved_panel(grid, factor, limit, top=lambda points: ()):
    """Blocks where they have gone to, over their outlines at rest; @p top are layers
    on the moved points."""
    moved = grid.points + factor * grid.of_points["displacement"][:, :2]
    colours = interpolate(SEQUENTIAL, magnitude(grid) / limit)
    return Panel(grid, outline(grid, colour=GREY, width=0.7),
                 fill(grid, colours, moved), outline(grid, moved), *top(moved))


def displacement_panel(results, limit, options):
    blocks = results.blocks()
    return moved_panel(blocks, options.fraction * block_size(blocks) / limit, limit)


def mechanism_panel(results, limit, options):
    grid, factor = results.mechanism(), getattr(options, "swing", 1.0)
    radius = min(0.3 * block_size(grid), 0.01 * np.hypot(*np.ptp(grid.points, 0)))
    return moved_panel(grid, factor, limit, lambda points: [
        discs(points[results.hinges()], radius, COMPRESSION)])


@dataclass
class View:
    """values: what the scale is for; reference: what makes small values rounding;
    scale: the colours of a bar, None for those of stresses; turning: only of blocks
    that turn; ranges: only with those of the forces; shows: what a result may have
    none of; labels: words below a bar, for its numbers."""
    file: str
    panel: Callable
    values: Callable = None
    reference: Callable = None
    scale: list = None
    legend: str = "bar"
    turning: bool = False
    ranges: bool = False
    shows: str = ""
    labels: tuple = None

    def missing(self, results):
        """What a result lacks for this view, in words, or None."""
        if not results.has(self.file):
            return (f"needs {self.file}, which '{results.directory}' does not have; "
                    f"its status is '{results.summary.get('status')}'")
        if self.turning and "eccentricity" not in results.grid(self.file).of_cells:
            return (f"needs results with Rotations = true, and those in "
                    f"'{results.directory}' are without")
        if self.ranges and "p_max" not in results.grid(self.file).of_cells:
            return ("needs ranges of forces, as of Ranges/Where = 1, and "
                    f"'{results.directory}' has none")
        if self.shows and not len(self.values(results, None)):
            return (f"shows {self.shows}, and '{results.directory}' has none but "
                    "rounding")
        return None


def stress_view(name):
    return View("blocks.vtu", partial(stress_panel, name),
                lambda results, options: component(name, results.stress()),
                lambda results: results.stress().of_cells["stress"])


def principal_values(results, options):
    return crosses(principal_grid(results, options))[-1]


def chain_values(results, options):
    return chains(results.blocks(), results.interfaces())[-1]


def thrust_values(results, options):
    return resultants(results.interfaces())[-1]


MECHANISM = View("mechanism.vtu", mechanism_panel,
                 lambda results, options: magnitude(results.mechanism()),
                 scale=SEQUENTIAL)
VIEWS = {
    **{name: stress_view(name)
       for name in ("sigma_xx", "sigma_xy", "sigma_yy", "von_mises")},
    "principal": View("blocks.vtu", principal_panel, principal_values,
                      lambda results: results.blocks().of_cells["stress"],
                      legend="principal"),
    "chains": View("interfaces.vtu", chain_panel, chain_values, forces,
                   legend="chains", shows="normal forces"),
    "thrust": View("interfaces.vtu", thrust_panel, thrust_values, legend="thrust",
                   turning=True, shows="pressed joints"),
    "resultants": View("interfaces.vtu", resultant_panel, resultant_values,
                       legend="resultants"),
    "loads": View("blocks.vtu", load_panel, load_values, legend="loads",
                  shows="loads"),
    "eccentricity": View("interfaces.vtu", eccentricity_panel, scale=MIDDLE_THIRD,
                         turning=True, labels=("middle", "1/6", "1/3", "end")),
    "utilisation": View("interfaces.vtu", utilisation_panel, scale=SEQUENTIAL),
    "ranges": View("interfaces.vtu", range_panel, range_values, forces,
                   scale=SEQUENTIAL, ranges=True),
    "blocks": View("blocks.vtu", group_panel, legend="groups"),
    "displacement": View("blocks.vtu", displacement_panel,
                         lambda results, options: magnitude(results.blocks()),
                         scale=SEQUENTIAL),
    "mechanism": MECHANISM,
    "animation": MECHANISM,
}
