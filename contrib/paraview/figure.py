"""A picture that is drawn in pixels, with (0, 0) at its lower left corner."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTextActor,
    vtkWindowToImageFilter)
import vtkmodules.vtkRenderingFreeType  # noqa: F401, draws the text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws all else

INK = (0.15, 0.15, 0.15)

# All figures share it, since to open one takes time.
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(8)


def poly_data(points, offsets, corners, lines):
    """Of points (n, 3)."""
    points_of_vtk, cells, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    points_of_vtk.SetData(numpy_to_vtk(points, deep=True))
    cells.SetData(numpy_to_vtkIdTypeArray(np.asarray(offsets, np.int64), deep=True),
                  numpy_to_vtkIdTypeArray(np.asarray(corners, np.int64), deep=True))
    data.SetPoints(points_of_vtk)
    (data.SetLines if lines else data.SetPolys)(cells)
    return data


class Figure:
    def __init__(self, width, height):
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        window.SetSize(width, height)
        window.GetRenderers().RemoveAllItems()
        window.AddRenderer(self.renderer)
        self.layers = 0
        camera = self.renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetParallelScale(height / 2)
        camera.SetFocalPoint(width / 2, height / 2, 0)
        far = 10 * max(width, height, 1000)
        camera.SetPosition(width / 2, height / 2, far)
        camera.SetClippingRange(1, 2 * far)

    def add(self, points, offsets, corners, colours, line_width=0):
        """Polygons, or lines of a width, above all that is already there, by a pixel
        if points have how near they are as a third coordinate.

        colours is one colour or one for each cell."""
        if len(offsets) < 2:
            return
        self.layers += 1
        nearness, in_space = points[:, 2:].sum(axis=1), points.shape[1] == 3
        points = np.column_stack((points[:, :2], nearness + self.layers))
        data = poly_data(points, offsets, corners, line_width > 0)
        colours = np.broadcast_to(colours, (len(offsets) - 1, 3))
        data.GetCellData().SetScalars(
            numpy_to_vtk(np.round(255 * colours).astype(np.uint8), deep=True))
        # OpenGL would draw what is not convex as a fan.
        mapper, actor, triangles = vtkPolyDataMapper(), vtkActor(), vtkTriangleFilter()
        triangles.SetInputData(data)
        mapper.SetInputConnection(triangles.GetOutputPort())
        actor.SetMapper(mapper)
        actor.GetProperty().LightingOff()
        if in_space:  # lines in front of steep polygons keep their width
            mapper.SetResolveCoincidentTopologyToPolygonOffset()
        if line_width:
            actor.GetProperty().SetLineWidth(line_width)
        self.renderer.AddActor(actor)

    def text(self, x, y, words, size, widest=np.inf):
        """A line centred at x, above y, made smaller if it is wider than widest."""
        actor = vtkTextActor()
        actor.SetInput(words)
        style = actor.GetTextProperty()
        style.SetColor(*INK)
        style.SetJustificationToCentered()
        style.SetVerticalJustificationToBottom()
        style.SetFontSize(int(size))
        extent = [0.0, 0.0]
        actor.GetSize(self.renderer, extent)
        if extent[0] > widest:
            style.SetFontSize(max(6, int(size * widest / extent[0])))
        actor.SetPosition(x, y)
        self.renderer.AddActor2D(actor)

    def rectangles(self, left, right, bottom, top, colours):
        """Beside each other: left and right are one for each, as colours."""
        n = len(left)
        x = np.stack((left, right, right, left), axis=1).reshape(-1)
        y = np.tile([bottom, bottom, top, top], n)
        self.add(np.column_stack((x, y)), np.arange(0, 4 * n + 1, 4),
                 np.arange(4 * n), colours)

    def image(self):
        window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(window)
        grab.SetInputBufferTypeToRGB()
        grab.ReadFrontBufferOff()
        grab.Update()
        return grab.GetOutput()


def write_png(image, file):
    writer = vtkPNGWriter()
    writer.SetCompressionLevel(9)
    writer.SetFileName(file)
    writer.SetInputData(image)
    writer.Write()
    if writer.GetErrorCode():
        raise OSError(f"'{file}' cannot be written.")
