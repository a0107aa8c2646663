"""A picture of a result: a field of stress.vtu with the interfaces on top.

    xvfb-run -a pvbatch contrib/paraview/picture.py DIRECTORY FIELD PICTURE.png
        [LIMIT]

DIRECTORY holds the results of voussoir; FIELD is a scalar of stress.vtu, such
as von_mises, or a component of the stress: sigma_xx, sigma_xy or sigma_yy. The
colours run from blue at -LIMIT (compression) over white at zero to red at LIMIT
(tension); by default LIMIT is the largest absolute value. Black lines are the
interfaces. If the load was not carried, FIELD is displacement_x or
displacement_y, of the blocks of mechanism.vtu, which are shown where the
mechanism has moved them.
"""
import sys

from paraview.simple import (
    CleantoGrid, ColorBy, CreateView, ExtractSurface, FeatureEdges,
    GetColorTransferFunction, GetScalarBar, Render, SaveScreenshot, Show,
    XMLUnstructuredGridReader)

directory, field, picture = sys.argv[1:4]


def read(name):
    reader = XMLUnstructuredGridReader(FileName=[f"{directory}/{name}"])
    reader.UpdatePipeline()
    return reader


# Where a component stands among the nine of the tensor and three of the vector.
array, index = {"sigma_xx": ("stress", 0), "sigma_xy": ("stress", 1),
                "sigma_yy": ("stress", 4), "displacement_x": ("displacement", 0),
                "displacement_y": ("displacement", 1)}.get(field, (field, 0))
collapse = array == "displacement"
blocks = read("mechanism.vtu" if collapse else "stress.vtu")

view = CreateView("RenderView")
view.Background = [1, 1, 1]
view.UseColorPaletteForBackground = 0
view.OrientationAxesVisibility = 0
view.InteractionMode = "2D"

colours = GetColorTransferFunction(array)
low, high = blocks.CellData.GetArray(array).GetRange(index)
extent = float(sys.argv[4]) if len(sys.argv) > 4 else max(abs(low), abs(high))
extent = extent or 1.0
shown = Show(blocks, view)
ColorBy(shown, ("CELLS", array))
if array in ("stress", "displacement"):
    colours.VectorMode, colours.VectorComponent = "Component", index
colours.AutomaticRescaleRangeMode = "Never"
colours.ColorSpace = "Lab"
colours.RGBPoints = [-extent, 0.09, 0.28, 0.60,
                     -0.5 * extent, 0.45, 0.66, 0.85,
                     0.0, 0.97, 0.97, 0.97,
                     0.5 * extent, 0.94, 0.60, 0.45,
                     extent, 0.66, 0.07, 0.12]
shown.Ambient, shown.Diffuse, shown.Specular = 1.0, 0.0, 0.0
shown.SetScalarBarVisibility(view, True)
bar = GetScalarBar(colours, view)
bar.Title = field
bar.ComponentTitle = ""
bar.TitleColor = bar.LabelColor = [0, 0, 0]
bar.TitleFontSize = bar.LabelFontSize = 20
bar.Orientation = "Horizontal"
bar.WindowLocation = "Lower Center"
bar.ScalarBarLength = 0.5

# Sides of blocks that meet merge, up to what a picture shows: lines are where the
# packing ends, and where blocks of a mechanism part.
merged = CleantoGrid(Input=blocks, Tolerance=1e-5)
outlines = [FeatureEdges(Input=ExtractSurface(Input=merged),
                         FeatureEdges=0, NonManifoldEdges=0)]
if not collapse:
    outlines.append(read("interfaces.vtu"))
for source in outlines:
    lines = Show(source, view)
    lines.ColorArrayName = [None, ""]
    lines.AmbientColor = lines.DiffuseColor = [0.1, 0.1, 0.1]
    lines.Ambient, lines.Diffuse = 1.0, 0.0
    lines.LineWidth = 1.5

# As large as the longer side allows, with room for the bar of colours below.
longest, margin, room = 860, 60, 120
bounds = blocks.GetDataInformation().GetBounds()
width, height = bounds[1] - bounds[0], bounds[3] - bounds[2]
pixel = max(width, height) / longest
view.ViewSize = [max(500, round(width / pixel) + margin),
                 round(height / pixel) + margin + room]
Render(view)  # the first time places the camera by itself
centre = [(bounds[0] + bounds[1]) / 2,
          (bounds[2] + bounds[3]) / 2 - room / 2 * pixel]
view.CameraParallelProjection = 1
view.CameraFocalPoint = [*centre, 0]
view.CameraPosition = [*centre, 10 * (width + height)]
view.CameraParallelScale = view.ViewSize[1] / 2 * pixel
Render(view)
SaveScreenshot(picture, view)
