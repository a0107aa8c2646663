"""A macro of ParaView that shows the results of voussoir.

In ParaView, Macros > Import new macro..., this file. Then open any file of a
result directory, such as results.pvd, select it in the pipeline browser, and
press the macro's button. What is new in the pipeline:

    Stress      the blocks' stress, coloured by its first component
    Outlines    of the blocks
    Crosses     of the principal stresses: each block's mean stress
    Chains      of forces: from centroid to centroid, as wide as the normal force
    Thrust      with Rotations = true, in place of the chains: the line of thrust

or, after a collapse, the mechanism, warped, over the blocks at rest. Crosses and
chains are blue where they press and red where they pull; chains and line of
thrust are hidden at first, and shown by the eye beside their names. All are
ordinary sources and filters, whose properties can be changed as always.

ParaView keeps a copy of a macro, so that this file needs no other. The functions
that draw are also the text of the programmable filters, which a state file takes
along, up to the line that says so; render.py draws with the same functions.
"""
import os

import numpy as np
from vtkmodules.util.numpy_support import (
    numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy)
from vtkmodules.vtkCommonCore import vtkPoints
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


def fill(output, begin, end, width, value):
    """Give a vtkPolyData the rectangles around lines, and their values."""
    corners = ribbons(begin, end, width)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(
        np.column_stack((corners, np.zeros(len(corners)))), deep=True))
    cells = vtkCellArray()
    cells.SetData(4, numpy_to_vtkIdTypeArray(np.arange(len(corners)), deep=True))
    values = numpy_to_vtk(value, deep=True)
    values.SetName("value")
    output.SetPoints(points)
    output.SetPolys(cells)
    output.GetCellData().AddArray(values)


# The text of the filters ends here.

CROSSES = """
limit = None  # the stress of an arm as long as the block; None: the largest
fill(output.VTKObject, *crosses(Grid(inputs[0].VTKObject), limit))
"""
CHAINS = """
limit = None  # the normal force of the widest line; None: the largest
fill(output.VTKObject,
     *chains(*(Grid(grid.VTKObject) for grid in inputs), limit))
"""
THRUST = """
limit = None  # the resultant of the widest line; None: the largest
fill(output.VTKObject,
     *thrust(*(Grid(grid.VTKObject) for grid in inputs), limit))
"""

# From compression (-1) to tension (1), for stresses with a sign.
DIVERGING = [(-1, 0.09, 0.28, 0.60), (-0.5, 0.45, 0.66, 0.85),
             (0, 0.97, 0.97, 0.97),
             (0.5, 0.94, 0.60, 0.45), (1, 0.66, 0.07, 0.12)]


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


def colour(shown, array, view, component=None, title="", bar=True):
    """Colours from compression to tension, under a title that is for people."""
    from paraview.simple import (ColorBy, GetColorTransferFunction, GetScalarBar)
    ColorBy(shown, ("CELLS", array))
    colours = GetColorTransferFunction(array)
    if component is not None:
        colours.VectorMode, colours.VectorComponent = "Component", component
    info = shown.Input.GetCellDataInformation().GetArray(array)
    limit = max(map(abs, info.GetRange(component or 0)), default=0) or 1.0
    colours.ColorSpace = "RGB"
    colours.AutomaticRescaleRangeMode = "Never"
    colours.RGBPoints = [x for at, *rgb in DIVERGING for x in (at * limit, *rgb)]
    shown.SetScalarBarVisibility(view, bar)
    if bar:
        legend = GetScalarBar(colours, view)
        legend.Title, legend.ComponentTitle = title or array, ""
    flat(shown)


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


def show_mechanism(mechanism, view):
    from paraview.simple import ColorBy, RenameSource, Show, WarpByVector
    warped = WarpByVector(Input=mechanism, Vectors=["POINTS", "displacement"],
                          ScaleFactor=1)
    RenameSource("Mechanism", warped)
    shown = Show(warped, view)
    ColorBy(shown, ("POINTS", "displacement"))
    shown.SetRepresentationType("Surface With Edges")
    shown.SetScalarBarVisibility(view, True)
    flat(shown)
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
    colour(Show(stress, view), "stress", view, component=0, title="sigma_xx")
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
            colour(shown, "value", view, title=name, bar=False)
        # One thing at a time: the eye in the pipeline browser shows it.
        if name != "Crosses":
            Hide(marks, view)


def main():
    from paraview.simple import (GetActiveSource, GetActiveViewOrCreate, Hide,
                                 Render, ResetCamera)
    selected = GetActiveSource()
    directory = result_directory(selected)
    view = GetActiveViewOrCreate("RenderView")
    view.InteractionMode = "2D"
    Hide(selected, view)
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
