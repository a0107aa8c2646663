"""A macro of ParaView that shows the results of voussoir.

In ParaView, Macros > Import new macro..., this file. Then open any file of a
result directory, such as results.pvd, select it in the pipeline browser, and
press the macro's button. What is new in the pipeline:

    Stress      the blocks' stress, coloured by its first component
    Outlines    of the blocks
    Crosses     of the principal stresses: each block's mean stress
    Chains      of forces: from centroid to centroid, as wide as the normal force
    Thrust      with Rotations = true, in place of the chains: the line of thrust

or, after a collapse, the mechanism, warped, over the blocks at rest. In space:

    Blocks      by their greatest compression, and only their far sides (Backface
                Representation), so that crosses are seen; without loads by group
    Outlines    of the blocks
    Crosses     of the principal stresses: each block's mean stress, in three arms
    Interfaces  by the utilisation of friction
    Mechanism   after a collapse or of a load factor, warped, and the blocks At rest

Crosses and chains are blue where they press and red where they pull. Chains, line of
thrust and interfaces, and in space all else beside a mechanism, are hidden at first,
and shown by the eye beside their names. All are ordinary sources and filters, whose
properties can be changed as always.

ParaView keeps a copy of a macro, so that this file needs no other. The functions
that draw are also the text of the programmable filters, which a state file takes
along, up to the line that says so; render.py draws with the same functions.
"""
import json
import os

import numpy as np
from vtkmodules.util.numpy_support import (
    numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy)
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray


def arrays(data):
    found = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
    return {array.GetName(): vtk_to_numpy(array) for array in found}


class Grid:
    """An unstructured grid: cell i has the points corners[offsets[i]:offsets[i+1]]."""

    def __init__(self, grid):
        self.size = grid.GetNumberOfCells()
        self.points = np.empty((0, 2))
        self.offsets, self.corners = np.zeros(1, int), np.empty(0, int)
        if self.size:
            self.points = vtk_to_numpy(grid.GetPoints().GetData())[:, :2]
            self.offsets = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
            self.corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
        self.of_cells = arrays(grid.GetCellData())
        self.of_points = arrays(grid.GetPointData())

    def areas_and_centroids(self):
        """Of polygons, about the first point of each, for the sake of digits."""
        first = self.offsets[:-1]
        origin = self.points[self.corners[first]]
        x = self.points[self.corners] - np.repeat(origin, np.diff(self.offsets), 0)
        following = np.arange(1, len(x) + 1)
        following[self.offsets[1:] - 1] = first
        y = x[following]
        cross = x[:, 0] * y[:, 1] - x[:, 1] * y[:, 0]
        area = np.add.reduceat(cross, first) / 2
        moment = np.add.reduceat((x + y) * cross[:, None], first) / 6
        return area, origin + moment / area[:, None]


def faces_of_cells(grid):
    """Of polyhedra, or polygons as they are: face j is of cell[j], and has the points
    vertices[offsets[j]:offsets[j+1]]."""
    cell, sizes, vertices, ids = [], [], [], vtkIdList()
    for i in range(grid.GetNumberOfCells()):
        grid.GetFaceStream(i, ids)
        stream = [ids.GetId(j) for j in range(ids.GetNumberOfIds())]
        if grid.GetCell(i).GetCellDimension() == 2:
            stream = [1, len(stream), *stream]
        at = 1
        for _ in range(stream[0]):
            cell.append(i)
            sizes.append(stream[at])
            vertices += stream[at + 1:at + 1 + stream[at]]
            at += 1 + stream[at]
    return (np.array(cell, int), np.cumsum([0, *sizes]), np.array(vertices, int))


class Polyhedra(Grid):
    """Blocks in space, the faces of which run outwards."""

    def __init__(self, grid):
        super().__init__(grid)
        self.points = vtk_to_numpy(grid.GetPoints().GetData())
        self.faces = faces_of_cells(grid)

    def triangles(self):
        """All faces as fans about their first points: the block of each triangle, and
        its corners (n, 3, 3). Of a face that is not convex they add up with signs."""
        cell, offsets, vertices = self.faces
        n = np.diff(offsets) - 2
        face = np.repeat(np.arange(len(n)), n)
        first = offsets[face]
        second = first + 1 + np.arange(len(face)) - np.repeat(np.cumsum(n) - n, n)
        corners = np.column_stack((first, second, second + 1))
        return cell[face], self.points[vertices[corners]]

    def centroids(self):
        """By tetrahedra from the first point of each block, for the sake of digits."""
        cell, triangles = self.triangles()
        origin = self.points[self.corners[self.offsets[:-1]]]
        a, b, c = (triangles - origin[cell][:, None]).swapaxes(0, 1)
        volume = (a * np.cross(b, c)).sum(1)
        moment = volume[:, None] * (a + b + c) / 4
        total = np.bincount(cell, volume, self.size)
        return origin + np.column_stack(
            [np.bincount(cell, m, self.size) for m in moment.T]) / total[:, None]


def crosses_in_space(blocks, limit=None):
    """Three arms a block that moves, along the principal directions of its mean
    stress: begin, end, width, value, block.

    An arm is as long as the cube root of the block's volume where the stress is
    limit."""
    moves = np.flatnonzero(blocks.of_cells["fixed"] == 0)
    stress = blocks.of_cells["mean_stress"][moves].reshape(-1, 3, 3)
    value, axes = np.linalg.eigh((stress + stress.swapaxes(1, 2)) / 2)
    limit = limit or np.abs(value).max(initial=0) or 1.0
    size = np.cbrt(blocks.of_cells["volume"][moves])[:, None]
    share = 0.5 * size * np.minimum(1, np.abs(value) / limit)
    arm = (share[:, None] * axes).swapaxes(1, 2)
    centre = blocks.centroids()[moves][:, None]
    width, block = (np.repeat(of, 3).reshape(-1, 3) for of in (0.09 * size, moves))
    drawn = np.abs(value) > 1e-9 * limit
    return [part[drawn] for part in (centre - arm, centre + arm, width, value, block)]


def crosses(blocks, limit=None):
    """Two arms a block along the principal directions: begin, end, width, value.

    An arm is as long as the root of the block's area where the stress is limit."""
    xx, xy, _, yx, yy = blocks.of_cells["stress"][:, :5].T
    area, centre = blocks.areas_and_centroids()
    mean, radius = (xx + yy) / 2, np.hypot((xx - yy) / 2, (xy + yx) / 2)
    angle = np.arctan2((xy + yx) / 2, (xx - yy) / 2) / 2
    value = np.concatenate((mean + radius, mean - radius))
    limit = limit or np.abs(value).max() or 1.0
    turned = np.concatenate((angle, angle + np.pi / 2))
    size = np.tile(np.sqrt(area), 2)
    arm = 0.5 * size * np.minimum(1, np.abs(value) / limit)
    arm = arm[:, None] * np.column_stack((np.cos(turned), np.sin(turned)))
    centre = np.tile(centre, (2, 1))
    drawn = np.abs(value) > 1e-9 * limit
    return [part[drawn] for part in (centre - arm, centre + arm, 0.12 * size, value)]


def chains(blocks, interfaces, limit=None):
    """Lines from the centroids of two blocks to the middle of their interface:
    begin, end, width, value.

    Where the normal force is limit, they are 0.3 of the mean block wide. Normal
    forces that are rounding beside the tangential ones are none."""
    if not interfaces.size:
        return np.empty((0, 2)), np.empty((0, 2)), np.empty(0), np.empty(0)
    area, centre = blocks.areas_and_centroids()
    force = interfaces.of_cells["normal_force"]
    minus, plus = (interfaces.of_cells[name] for name in ("cell_minus", "cell_plus"))
    middle = interfaces.points[interfaces.corners.reshape(-1, 2)].mean(axis=1)
    largest = np.abs(interfaces.of_cells["tangential_force"]).max()
    pressed = np.abs(force) > 1e-9 * np.maximum(np.abs(force).max(), largest)
    limit = limit or np.abs(force).max() or 1.0
    half = pressed & (plus >= 0)
    begin = np.concatenate((centre[minus[pressed]], centre[plus[half]]))
    end = np.concatenate((middle[pressed], middle[half]))
    value = np.concatenate((force[pressed], force[half]))
    width = 0.3 * np.sqrt(area.mean()) * np.minimum(1, np.abs(value) / limit)
    return begin, end, width, value


def resultants(interfaces):
    """Of the joints that are pressed: which they are, where the resultant passes
    through them, and its size."""
    normal, tangential, place = (
        interfaces.of_cells[name]
        for name in ("normal_force", "tangential_force", "eccentricity"))
    pressed = np.flatnonzero(-normal > 1e-6 * np.abs(normal).max(initial=0))
    ends = interfaces.points[interfaces.corners.reshape(-1, 2)[pressed]]
    along = ends[:, 1] - ends[:, 0]
    at = ends.mean(axis=1) + place[pressed, None] * along
    return pressed, at, np.hypot(normal, tangential)[pressed]


def thrust(blocks, interfaces, limit=None):
    """The line of thrust: begin, end, width, value.

    In each block, from where the resultants pass through its joints to the mean of
    these points, weighted by the resultants: with two pressed joints a straight line
    from one to the other. With a single one to the centroid of the block, where its
    weight acts. Where the resultant is limit, lines are 0.2 of the mean block wide,
    but not more than 0.01 of the packing, and nowhere less than a third of that."""
    if not interfaces.size:
        return np.empty((0, 2)), np.empty((0, 2)), np.empty(0), np.empty(0)
    pressed, at, size = resultants(interfaces)
    minus, plus = (interfaces.of_cells[name][pressed]
                   for name in ("cell_minus", "cell_plus"))
    block = np.concatenate((minus, plus[plus >= 0]))
    begin, value = (np.concatenate((of, of[plus >= 0])) for of in (at, size))
    area, middle = blocks.areas_and_centroids()
    several = np.bincount(block, minlength=blocks.size) > 1
    total = np.bincount(block, value, blocks.size)[several]
    for i in (0, 1):
        moment = np.bincount(block, value * begin[:, i], blocks.size)
        middle[several, i] = moment[several] / total
    share = np.minimum(1, value / (limit or value.max(initial=0) or 1.0))
    widest = np.minimum(0.2 * np.sqrt(area.mean()),
                        0.01 * np.hypot(*np.ptp(blocks.points, 0)))
    return begin, middle[block], widest * (1 + 2 * share) / 3, value


def ribbons(begin, end, width):
    """The corners of the rectangles around lines, (4 n, 2)."""
    along = end - begin
    length = np.hypot(along[:, 0], along[:, 1])
    across = np.column_stack((-along[:, 1], along[:, 0]))
    across *= (width / 2 / np.where(length > 0, length, 1))[:, None]
    corners = (begin - across, end - across, end + across, begin + across)
    return np.stack(corners, axis=1).reshape(-1, 2)


# The sides of a bar, outwards, by its corners.
SIDES = np.array([(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6),
                  (3, 0, 4, 7)])


def bars(begin, end, width):
    """The sides of square bars around lines in space, (6 n, 4, 3)."""
    along = end - begin
    length = np.linalg.norm(along, axis=1)
    along = along / np.where(length > 0, length, 1)[:, None]
    right = np.cross(along, np.eye(3)[np.abs(along).argmin(axis=1)])
    size = np.linalg.norm(right, axis=1)
    right *= (width / 2 / np.where(size > 0, size, 1))[:, None]
    up = np.cross(along, right)
    around = (-right - up, right - up, right + up, up - right)
    corners = np.stack([at + to for at in (begin, end) for to in around], axis=1)
    return corners[:, SIDES].reshape(-1, 4, 3)


def fill(output, corners, **fields):
    """Give a vtkPolyData quadrilaterals, (4 n, 2) or (4 n, 3), and their values."""
    flat = np.zeros((len(corners), 3 - corners.shape[1]))
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.hstack((corners, flat)), deep=True))
    cells = vtkCellArray()
    cells.SetData(4, numpy_to_vtkIdTypeArray(np.arange(len(corners)), deep=True))
    output.SetPoints(points)
    output.SetPolys(cells)
    for name, values in fields.items():
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        output.GetCellData().AddArray(array)


# The text of the filters ends here.

CROSSES = """
limit = None  # the stress of an arm as long as the block; None: the largest
*lines, value = crosses(Grid(inputs[0].VTKObject), limit)
fill(output.VTKObject, ribbons(*lines), value=value)
"""
CROSSES_IN_SPACE = """
limit = None  # the stress of an arm as long as the block; None: the largest
*lines, value, block = crosses_in_space(Polyhedra(inputs[0].VTKObject), limit)
fill(output.VTKObject, bars(*lines).reshape(-1, 3), value=np.repeat(value, 6),
     cell=np.repeat(block, 6))
"""
CHAINS = """
limit = None  # the normal force of the widest line; None: the largest
*lines, value = chains(*(Grid(grid.VTKObject) for grid in inputs), limit)
fill(output.VTKObject, ribbons(*lines), value=value)
"""
THRUST = """
limit = None  # the resultant of the widest line; None: the largest
*lines, value = thrust(*(Grid(grid.VTKObject) for grid in inputs), limit)
fill(output.VTKObject, ribbons(*lines), value=value)
"""

# From compression (-1) to tension (1), for stresses with a sign.
DIVERGING = [(-1, 0.09, 0.28, 0.60), (-0.5, 0.45, 0.66, 0.85),
             (0, 0.97, 0.97, 0.97),
             (0.5, 0.94, 0.60, 0.45), (1, 0.66, 0.07, 0.12)]
# From 0 to 1, for what is not negative: utilisation, displacement, von_mises.
SEQUENTIAL = [(0, 0.80, 0.84, 0.88), (0.5, 0.96, 0.68, 0.25), (1, 0.55, 0.03, 0.18)]
# Of crosses in blocks that are coloured, too.
PRESSED_OR_PULLED = [(-1, 0.02, 0.05, 0.22), (-1e-9, 0.02, 0.05, 0.22),
                     (1e-9, 0.80, 0.05, 0.10), (1, 0.80, 0.05, 0.10)]
# Of groups of blocks, repeated if there are more.
GROUPS = [(0.85, 0.72, 0.55), (0.58, 0.71, 0.78), (0.72, 0.52, 0.47),
          (0.67, 0.76, 0.55), (0.76, 0.66, 0.80), (0.93, 0.86, 0.58)]


def filter_text(call):
    """The functions that draw, from the file of the macro, and a call of them."""
    with open(__file__, encoding="utf-8") as file:
        return file.read().split("\n# The text of the filters ends here.")[0] + call


def result_directory(source):
    """Where the file was read of which a source shows something."""
    while source is not None:
        for name in ("FileName", "FileNames"):
            if source.GetProperty(name):
                file = source.GetPropertyValue(name)
                file = file if isinstance(file, str) else file[0]
                return os.path.dirname(os.path.abspath(file))
        source = getattr(source, "Input", None)
        if source is not None and not hasattr(source, "GetProperty"):
            source = source[0]  # the first of several
    raise RuntimeError("Open a file of a result directory and select it first.")


def read_summary(directory):
    """Empty without one, as of runs that were interrupted."""
    file = os.path.join(directory, "summary.json")
    if not os.path.exists(file):
        return {}
    with open(file, encoding="utf-8") as opened:
        return json.load(opened)


def colour(shown, array, view, component=None, title="", bar=True, scale=DIVERGING):
    """Colours from compression to tension, or of another scale, under a title that is
    for people."""
    from paraview.simple import (ColorBy, GetColorTransferFunction, GetScalarBar)
    ColorBy(shown, ("CELLS", array))
    colours = GetColorTransferFunction(array)
    if component is not None:
        colours.VectorMode, colours.VectorComponent = "Component", component
    info = shown.Input.GetCellDataInformation().GetArray(array)
    limit = max(map(abs, info.GetRange(component or 0)), default=0) or 1.0
    colours.ColorSpace = "RGB"
    colours.AutomaticRescaleRangeMode = "Never"
    colours.RGBPoints = [x for at, *rgb in scale for x in (at * limit, *rgb)]
    shown.SetScalarBarVisibility(view, bar)
    if bar:
        legend = GetScalarBar(colours, view)
        legend.Title, legend.ComponentTitle = title or array, ""
    return shown


def flat(shown):
    """As the colour is, without light."""
    shown.Ambient, shown.Diffuse, shown.Specular = 1.0, 0.0, 0.0


def move_to(shown, height):
    """Along z, by the property of ParaView from 5.13 on, or the earlier one."""
    name = "Translation" if hasattr(shown, "Translation") else "Position"
    setattr(shown, name, [0, 0, height])


def outline(source, view, behind=0):
    """The sides of blocks, so far behind what else is shown."""
    from paraview.simple import Show
    shown = Show(source, view)
    move_to(shown, -behind)
    shown.SetRepresentationType("Wireframe")
    shown.ColorArrayName = [None, ""]
    shown.AmbientColor = shown.DiffuseColor = [0.15, 0.15, 0.15]
    flat(shown)
    return shown


def read(directory, name, shown_name):
    """A reader of a file, or None if there is no such file."""
    from paraview.simple import OpenDataFile, RenameSource
    file = os.path.join(directory, name)
    if not os.path.exists(file):
        return None
    reader = OpenDataFile(file)
    RenameSource(shown_name, reader)
    reader.UpdatePipeline()
    return reader


def show_moved(source, factor, view):
    """Blocks where they have gone to, by a multiple of their displacement."""
    from paraview.simple import ColorBy, RenameSource, Show, WarpByVector
    warped = WarpByVector(Input=source, Vectors=["POINTS", "displacement"],
                          ScaleFactor=factor)
    RenameSource("Mechanism", warped)
    shown = Show(warped, view)
    ColorBy(shown, ("POINTS", "displacement"))
    shown.SetRepresentationType("Surface With Edges")
    shown.SetScalarBarVisibility(view, True)
    return shown


def show_mechanism(mechanism, view):
    flat(show_moved(mechanism, 1, view))
    bounds = mechanism.GetDataInformation().GetBounds()
    outline(mechanism, view, behind=1e-3 * max(bounds[1] - bounds[0],
                                               bounds[3] - bounds[2]))


def show_stress(directory, view):
    from paraview.simple import Hide, ProgrammableFilter, RenameSource, Show
    blocks = read(directory, "blocks.vtu", "Outlines")
    interfaces = read(directory, "interfaces.vtu", "Interfaces")
    stress = (read(directory, "stress.vtu", "Stress") or
              read(directory, "stress.pvtu", "Stress") or blocks)
    if not blocks or not interfaces:
        raise RuntimeError(f"'{directory}' has no results with blocks.vtu.")
    flat(colour(Show(stress, view), "stress", view, component=0, title="sigma_xx"))
    outline(blocks, view)
    turns = interfaces.CellData.GetArray("eccentricity") is not None
    lines = ("Thrust", THRUST) if turns else ("Chains", CHAINS)
    for name, call, inputs in (("Crosses", CROSSES, blocks),
                               (*lines, [blocks, interfaces])):
        marks = ProgrammableFilter(Input=inputs, Script=filter_text(call),
                                   OutputDataSetType="vtkPolyData")
        RenameSource(name, marks)
        marks.UpdatePipeline()
        shown = Show(marks, view)
        move_to(shown, 0)
        if name == "Thrust":
            shown.ColorArrayName = [None, ""]
            shown.AmbientColor = shown.DiffuseColor = [0.1, 0.1, 0.1]
            flat(shown)
        elif marks.GetDataInformation().GetNumberOfCells() > 0:
            flat(colour(shown, "value", view, title=name, bar=False))
        # One thing at a time: the eye in the pipeline browser shows it.
        if name != "Crosses":
            Hide(marks, view)


def name_groups(shown, groups, view):
    """Blocks in the colours of their groups, which have names."""
    from paraview.simple import ColorBy, GetColorTransferFunction, GetScalarBar
    ColorBy(shown, ("CELLS", "group"))
    colours = GetColorTransferFunction("group")
    colours.InterpretValuesAsCategories = 1
    colours.Annotations = [text for i, group in enumerate(groups)
                           for text in (str(i), group["name"])]
    colours.IndexedColors = [channel for i in range(len(groups))
                             for channel in GROUPS[i % len(GROUPS)]]
    shown.SetScalarBarVisibility(view, True)
    GetScalarBar(colours, view).Title = "group"


def motion_of_mechanism(blocks, summary):
    """By how much that of the fastest point has to be multiplied to be half of the mean
    block; None if the blocks have no mechanism, but perhaps an elastic motion."""
    from paraview.servermanager import Fetch
    grid = Fetch(blocks)
    motion = grid.GetPointData().GetArray("displacement")
    if not motion or not {"mechanism", "load_factor"} & summary.keys():
        return None
    largest = np.linalg.norm(vtk_to_numpy(motion), axis=1).max()
    volume = vtk_to_numpy(grid.GetCellData().GetArray("volume"))
    return 0.5 * np.cbrt(volume.mean()) / largest if largest > 0 else None


def show_stress_in_space(directory, blocks, view):
    """Blocks of which the far sides are shown, with the crosses in them, and
    interfaces, which are hidden; the sources of the others."""
    from paraview.simple import Hide, ProgrammableFilter, RenameSource, Show
    shown = colour(Show(blocks, view), "principal_stress_min", view,
                   title="greatest compression")
    shown.BackfaceRepresentation = "Cull Frontface"
    shown.Ambient, shown.Diffuse = 0.6, 0.4
    marks = ProgrammableFilter(Input=blocks, Script=filter_text(CROSSES_IN_SPACE),
                               OutputDataSetType="vtkPolyData")
    RenameSource("Crosses", marks)
    marks.UpdatePipeline()
    shown = Show(marks, view)
    if marks.GetDataInformation().GetNumberOfCells() > 0:
        colour(shown, "value", view, title="Crosses", bar=False,
               scale=PRESSED_OR_PULLED)
    interfaces = read(directory, "interfaces.vtu", "Interfaces")
    if interfaces and interfaces.CellData.GetArray("utilisation") is not None:
        colour(Show(interfaces, view), "utilisation", view, bar=False, scale=SEQUENTIAL)
        Hide(interfaces, view)
    return [blocks, marks]


def show_in_space(directory, summary, view):
    from paraview.simple import Hide, RenameSource, Show
    blocks = read(directory, "blocks.vtu", "Blocks")
    if not blocks:
        raise RuntimeError(f"'{directory}' has no results with blocks.vtu.")
    at_rest = read(directory, "blocks.vtu", "Outlines")
    outline(at_rest, view).Opacity = 0.3
    made, factor = [blocks], motion_of_mechanism(blocks, summary)
    if blocks.CellData.GetArray("principal_stress_min") is not None:
        made = show_stress_in_space(directory, blocks, view)
    else:
        name_groups(Show(blocks, view), summary["packing"]["groups"], view)
    if factor:
        for source in made:
            Hide(source, view)
        RenameSource("At rest", at_rest)
        show_moved(at_rest, factor, view)


def look_at_space(view):
    """From the right, in front and above."""
    view.InteractionMode = "3D"
    focus = np.array(view.CameraFocalPoint)
    view.CameraPosition, view.CameraViewUp = list(focus + [1, -1, 1]), [0, 0, 1]


def main():
    from paraview.simple import (GetActiveSource, GetActiveViewOrCreate, Hide,
                                 Render, ResetCamera)
    selected = GetActiveSource()
    directory = result_directory(selected)
    summary = read_summary(directory)
    view = GetActiveViewOrCreate("RenderView")
    Hide(selected, view)
    if summary.get("dimension") == 3:
        look_at_space(view)
        show_in_space(directory, summary, view)
    else:
        view.InteractionMode = "2D"
        mechanism = read(directory, "mechanism.vtu", "At rest")
        if mechanism:
            show_mechanism(mechanism, view)
        else:
            show_stress(directory, view)
    ResetCamera(view)
    Render(view)


# As a program, or by the button: ParaView then runs it in the console.
if __name__ in ("__main__", "__vtkconsole__"):
    main()
