"""The views of packings in space: polygons as the viewer sees them, with how near they
are as a third coordinate, by which the figure hides what is behind them."""
import re
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from macro import faces_of_cells
from voussoir_views import (DARK, GREY, GROUPS, SEQUENTIAL, Layer, NotThere, Panel,
                            View, interpolate)

# How many radii of the packing the viewer is away from its middle.
DISTANCE = 7.0
# The light comes from the upper left; the brightness where it does not fall.
LIGHT, SHADE = np.array([-0.45, 0.65, 0.61]), 0.7
# How much is left of the colour of a group where a block is cut.
FADED = 0.45
# A plane that cuts passes vertices by this part of the packing.
BESIDE = 1e-7
JOINT, SUPPORT = (0.60, 0.72, 0.80), (0.75, 0.40, 0.30)


def direction(text):
    """Of --from: the unit vector towards the viewer."""
    vector = np.array([float(part) for part in text.split(",")])
    length = np.linalg.norm(vector)
    if vector.shape != (3,) or not 0 < length < np.inf:
        raise ValueError
    return vector / length


def half_space(text):
    """Of --cut: the normal of the plane, towards what is cut away, and its offset."""
    found = re.fullmatch(r"\s*([xyz])\s*([<>])(.+)", text)
    if not found:
        raise ValueError
    axis, side, value = found.groups()
    sign = 1 if side == ">" else -1
    return sign * np.eye(3)["xyz".index(axis)], sign * float(value)


def following(offsets):
    """Of each corner of polygons, the next one."""
    result = np.arange(1, offsets[-1] + 1)
    result[offsets[1:] - 1] = offsets[:-1]
    return result


@dataclass
class Faces:
    """Polygons with points of their own. vertices tells the points of one block
    apart, block is that of each polygon, and is_cut says whether a cut has made it."""
    points: np.ndarray
    vertices: np.ndarray
    offsets: np.ndarray
    block: np.ndarray
    is_cut: np.ndarray

    @classmethod
    def of(cls, polygons):
        """Of points, vertices, block and is_cut of each."""
        points, vertices, block, is_cut = zip(*polygons)
        return cls(np.concatenate(points), np.concatenate(vertices),
                   np.cumsum([0, *map(len, points)]), np.array(block), np.array(is_cut))

    def polygons(self):
        at = self.offsets[1:-1]
        return zip(np.split(self.points, at), np.split(self.vertices, at), self.block)

    def normals(self):
        """Unit normals, outwards."""
        first = self.offsets[:-1]
        x = self.points - np.repeat(self.points[first], np.diff(self.offsets), 0)
        normal = np.add.reduceat(np.cross(x, x[following(self.offsets)]), first)
        return normal / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]

    def middles(self):
        """Of all points of each block."""
        block = np.repeat(self.block, np.diff(self.offsets))
        sums = np.column_stack([np.bincount(block, x) for x in self.points.T])
        return sums / np.maximum(np.bincount(block), 1)[:, None]

    def apart(self, factor, middles):
        """Blocks moved away from the middle of the packing."""
        away = factor * (middles - (middles.min(0) + middles.max(0)) / 2)
        moved = np.repeat(away[self.block], np.diff(self.offsets), 0)
        return replace(self, points=self.points + moved)

    def some(self, chosen):
        """Those polygons of which chosen is true."""
        of_points = np.repeat(chosen, np.diff(self.offsets))
        sizes = np.diff(self.offsets)[chosen]
        return Faces(self.points[of_points], self.vertices[of_points],
                     np.cumsum([0, *sizes]), self.block[chosen], self.is_cut[chosen])


def faces_of(grid):
    """Of polyhedra, or polygons as they are."""
    points = vtk_to_numpy(grid.GetPoints().GetData())
    block, offsets, vertices = faces_of_cells(grid)
    return Faces(points[vertices], vertices, offsets, block, np.zeros(len(block), bool))


def loops(after):
    """The closed lines of a dictionary from each place to the one after it."""
    while after:
        loop, place = [], next(iter(after))
        while place in after:
            loop.append(place)
            place = after.pop(place)
        if len(loop) > 2:
            yield loop


def cut(faces, normal, offset):
    """What is left of blocks below a plane, closed by polygons in the plane."""
    offset -= BESIDE * np.ptp(faces.points, 0).max()
    left, places, after = [], {}, {}
    for (points, vertices, block), out in zip(faces.polygons(), faces.normals()):
        height = points @ normal - offset
        part, crossed = [], []
        for i, j in zip(range(len(points)), (*range(1, len(points)), 0)):
            if height[i] < 0:
                part.append(points[i])
            if (height[i] < 0) != (height[j] < 0):
                edge = (block, *sorted((vertices[i], vertices[j])))
                share = height[i] / (height[i] - height[j])
                places[edge] = points[i] + share * (points[j] - points[i])
                part.append(places[edge])
                crossed.append(edge)
        # Around what is cut through, the block is on the left.
        crossed.sort(key=lambda edge: places[edge] @ np.cross(normal, out))
        after.update(zip(crossed[::2], crossed[1::2]))
        if part:
            left.append((part, np.zeros(len(part), int), block, False))
    for loop in loops(after):
        left.append(([places[edge] for edge in loop], np.zeros(len(loop), int),
                     loop[0][0], True))
    if not left:
        raise NotThere("Nothing is left of the packing by this --cut.")
    return Faces.of(left)


@lru_cache(maxsize=None)
def faces_in(results, file):
    """Of a file of results."""
    return faces_of(results.read(file))


def faces_shown(results, file, options, move=lambda faces: faces):
    """Of the file, as the options of a picture have them; what moves is cut and
    taken apart where it was at rest."""
    faces = move(faces_in(results, file))
    middles = faces.middles()
    if options.cut:
        faces = cut(faces, *options.cut)
    return faces.apart(options.apart, middles)


class Eye:
    """What a viewer in a direction sees of a packing, in perspective.

    Planes stay planes with nearness as a coordinate, so that what hides is exact."""

    def __init__(self, packing, towards):
        right = np.array([-towards[1], towards[0], 0.0])
        right = right / np.linalg.norm(right) if right.any() else np.eye(3)[0]
        self.frame = np.column_stack((right, np.cross(towards, right), towards))
        self.middle = (packing.points.min(0) + packing.points.max(0)) / 2
        self.distance = DISTANCE * np.linalg.norm(packing.points - self.middle,
                                                  axis=1).max()
        self.at = self.middle + self.distance * towards

    def facing(self, faces):
        """Positive of those of which the outer side is seen."""
        to_viewer = self.at - faces.points[faces.offsets[:-1]]
        return (faces.normals() * to_viewer).sum(axis=1)

    def places(self, points):
        points = (points - self.middle) @ self.frame
        return points * (self.distance / (self.distance - points[:, 2:]))

    def light(self, normals):
        return SHADE + (1 - SHADE) * np.clip(normals @ self.frame @ LIGHT, 0, 1)

    def fill(self, faces, colours):
        """A colour for each face."""
        return Layer(self.places(faces.points), faces.offsets,
                     np.arange(len(faces.points)), colours)

    def outline(self, faces, colour=DARK, width=1):
        corners = np.arange(len(faces.points))
        closed = np.insert(corners, faces.offsets[1:], faces.offsets[:-1])
        offsets = faces.offsets + np.arange(len(faces.offsets))
        return Layer(self.places(faces.points), offsets, closed, colour, width)


def seen(results, faces, colours, options, both_sides=False, of_cut=1.0):
    """A panel of polygons in the colours of their blocks: of the faces of a cut, which
    have no shade, so much of the colour is left."""
    eye = Eye(faces, options.viewer)
    normal, facing = faces.normals(), eye.facing(faces)
    if both_sides:
        normal = normal * np.sign(facing)[:, None]
    else:
        faces, normal = faces.some(facing > 0), normal[facing > 0]
    light = eye.light(normal)
    light[faces.is_cut] = 1
    colours = colours[faces.block] * light[:, None]
    colours[faces.is_cut] = 1 - of_cut * (1 - colours[faces.is_cut])
    return Panel(results.blocks(), eye.fill(faces, colours), eye.outline(faces))


def named_groups(results):
    """Those of blocks that move, if they are few, and not one alone."""
    of = results.blocks().of_cells
    groups = np.unique(of["group"][of["fixed"] == 0])
    return groups if 1 < len(groups) <= len(GROUPS) else []


def group_panel(results, limit, options):
    """Blocks whose groups are not named have colours in turn."""
    of = results.blocks().of_cells
    number = of["group"] if len(named_groups(results)) else of["cell"]
    colours = np.where(of["fixed"][:, None] == 1, GREY, GROUPS[number % len(GROUPS)])
    return seen(results, faces_shown(results, "blocks.vtu", options), colours, options,
                of_cut=FADED)


def volumes(results, options=None):
    return results.blocks().of_cells["volume"]


def volume_panel(results, limit, options):
    colours = interpolate(SEQUENTIAL, volumes(results) / limit)
    return seen(results, faces_shown(results, "blocks.vtu", options), colours, options)


def areas(results, options=None):
    return results.interfaces().of_cells.get("area", np.empty(0))


def joint_panel(results, limit, options):
    support = results.interfaces().of_cells["support"][:, None] == 1
    return seen(results, faces_shown(results, "interfaces.vtu", options),
                np.where(support, SUPPORT, JOINT), options, both_sides=True)


@dataclass
class SpaceView(View):
    """field: what cells of the file must have, if loads are carried; falls: only where
    blocks have the motion of a mechanism."""
    field: str = ""
    falls: bool = False

    def missing(self, results):
        directory = results.directory
        if results.has(self.file):
            grid = results.grid(self.file)
            if not grid.size:
                return f"shows interfaces, and '{directory}' has none but rounding"
            if self.field and self.field not in grid.of_cells:
                return f"needs loads that are carried, and '{directory}' has none"
        if lack := super().missing(results):
            return lack
        if self.falls and not ({"mechanism", "load_factor"} & results.summary.keys()
                               and "displacement" in grid.of_points):
            return f"shows a mechanism, and '{directory}' has none"
        return None


def sizes_of_motion(results, options=None):
    """The largest displacement of each block, over that of all."""
    faces = faces_in(results, "blocks.vtu")
    of_points = np.linalg.norm(
        results.blocks().of_points["displacement"][faces.vertices], axis=1)
    largest = np.zeros(results.blocks().size)
    np.maximum.at(largest, np.repeat(faces.block, np.diff(faces.offsets)), of_points)
    return largest / max(largest.max(initial=0), 1e-300)


def mechanism_panel(results, limit, options):
    """Blocks where they have gone to: the fastest by a part of a block."""
    motion = results.blocks().of_points["displacement"]
    largest = max(np.linalg.norm(motion, axis=1).max(initial=0), 1e-300)
    factor = options.fraction * np.cbrt(volumes(results).mean()) / largest

    def move(faces):
        return replace(faces, points=faces.points + factor * motion[faces.vertices])

    colours = interpolate(SEQUENTIAL, sizes_of_motion(results) / limit)
    return seen(results, faces_shown(results, "blocks.vtu", options, move), colours,
                options)


def largest_pressures(results, options=None):
    """The least principal stress of each block."""
    return results.blocks().of_cells["principal_stress_min"]


def pressure_panel(results, limit, options):
    scale, sign = options.colours
    colours = interpolate(scale, largest_pressures(results) / (sign * limit))
    return seen(results, faces_shown(results, "blocks.vtu", options), colours, options)


def utilisation_panel(results, limit, options):
    colours = interpolate(SEQUENTIAL, results.interfaces().of_cells["utilisation"])
    return seen(results, faces_shown(results, "interfaces.vtu", options), colours,
                options, both_sides=True)


BLOCK_VIEWS_IN_SPACE = {
    "blocks": View("blocks.vtu", group_panel, legend="groups"),
    "volume": View("blocks.vtu", volume_panel, volumes, scale=SEQUENTIAL),
    "joints": View("interfaces.vtu", joint_panel, areas, legend="joints",
                   shows="interfaces"),
    "principal_stress_min": SpaceView(
        "blocks.vtu", pressure_panel, largest_pressures,
        lambda results: results.blocks().of_cells["mean_stress"],
        field="principal_stress_min"),
    "utilisation": SpaceView("interfaces.vtu", utilisation_panel, scale=SEQUENTIAL,
                             field="utilisation"),
    "mechanism": SpaceView("blocks.vtu", mechanism_panel, sizes_of_motion,
                           scale=SEQUENTIAL, falls=True)}
