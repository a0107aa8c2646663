"""The shear wall's files, as ParaView's reader sees them, carried and not.

With +-1 along the top and bottom of 12 courses of 6 bricks, 78 in all, every
interface of a bed carries the tangential stress 1 and no normal stress.
"""
import csv
import sys

import numpy as np
from paraview.servermanager import Fetch
from paraview.simple import (PVDReader, XMLPartitionedUnstructuredGridReader,
                             XMLUnstructuredGridReader)
from vtk.util.numpy_support import vtk_to_numpy

directory, collapse, uniform, arch, together, pieces = sys.argv[1:]


def read(name, directory=directory, reader=XMLUnstructuredGridReader):
    reader = reader(FileName=[f"{directory}/{name}"])
    reader.UpdatePipeline()
    return reader


def expect(what, found, expected):
    if found != expected:
        sys.exit(f"{what}: {found} found, {expected} expected")


def expect_range(reader, name, component, low, high):
    found = reader.CellData.GetArray(name).GetRange(component)
    if abs(found[0] - low) > 1e-6 or abs(found[1] - high) > 1e-6:
        sys.exit(f"{name}: {found} found, [{low}, {high}] expected")


def expect_equal(what, found, expected):
    if not np.array_equal(found, expected):
        sys.exit(f"{what}: not as expected, to the last bit")


def columns(name, *chosen, directory=directory):
    """Columns of a .csv file, (n, number of columns)."""
    rows = csv.DictReader(open(f"{directory}/{name}"))
    return np.array([[float(row[column]) for column in chosen]
                     for row in rows])


def expect_padding(file):
    """That white space keeps expat, of whatever version, from the data.

    VTK reads 4096 bytes at a time; without two times as much before the data
    Debian's expat of today makes its reader stumble over it.
    """
    content = open(file, "rb").read()
    begin = content.index(b'<AppendedData encoding="raw">') + 29
    end = content.index(b"_", begin)
    expect("white space before the data of " + file,
           (end - begin >= 2 * 4096, content[begin:end].strip()), (True, b""))


class Grid:
    """All values of a grid."""

    def __init__(self, reader):
        grid = Fetch(reader)
        self.points = vtk_to_numpy(grid.GetPoints().GetData())
        self.corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
        self.first = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
        self.fields = self.arrays(grid.GetCellData())
        self.point_fields = self.arrays(grid.GetPointData())

    @staticmethod
    def arrays(data):
        arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
        return {array.GetName(): vtk_to_numpy(array) for array in arrays}

    def owner(self):
        """The cell of each point, where cells share none."""
        return np.repeat(np.arange(len(self.first) - 1), np.diff(self.first))

    def areas(self):
        """Of polygons that share no points, by the sum of cross products."""
        x, y = self.points[:, 0], self.points[:, 1]
        after = np.arange(1, len(x) + 1)
        after[self.first[1:] - 1] = self.first[:-1]
        return 0.5 * np.add.reduceat(x * y[after] - x[after] * y,
                                     self.first[:-1])

    def expect_types(self, integers):
        for name, values in self.fields.items():
            expect(f"type of {name}", str(values.dtype),
                   integers.get(name, "float64"))


def components(data):
    return {data.GetArray(i).Name: data.GetArray(i).GetNumberOfComponents()
            for i in range(data.GetNumberOfArrays())}


def expect_pieces(whole, directory):
    """That the pieces there join to the same grid."""
    joined = Grid(read("stress.pvtu", directory,
                       XMLPartitionedUnstructuredGridReader))
    expect("fields of the pieces", list(joined.fields), list(whole.fields))
    for name, values in whole.fields.items():
        expect_equal(f"{name} of the pieces", joined.fields[name], values)
    expect_equal("displacement of the pieces",
                 joined.point_fields["displacement"],
                 whole.point_fields["displacement"])
    expect_equal("points of the pieces", joined.points, whole.points)
    expect_equal("corners of the pieces", joined.corners, whole.corners)


for name in ("blocks.vtu", "stress.vtu", "interfaces.vtu"):
    expect_padding(f"{directory}/{name}")

rows = list(csv.DictReader(open(f"{directory}/interfaces.csv")))
n_cells = len(list(csv.DictReader(open(f"{directory}/cells.csv"))))
expect("cells", n_cells, 78)

interfaces = read("interfaces.vtu")
expect("fields of interfaces.vtu", components(interfaces.CellData),
       {"force": 3} | {name: 1 for name in
        ("normal_force", "tangential_force", "normal_stress",
         "tangential_stress", "strength", "utilisation", "cell_minus",
         "cell_plus")})
info = interfaces.GetDataInformation()
expect("lines", info.GetNumberOfCells(), len(rows))
expect_range(interfaces, "normal_stress", 0, 0, 0)
expect_range(interfaces, "tangential_stress", 0, -1, 0)
expect_range(interfaces, "utilisation", 0, 0, 0.1)

# The numbers in the .vtu are those in the .csv file.
grid = Grid(interfaces)
grid.expect_types({"cell_minus": "int32", "cell_plus": "int32"})
for name in ("normal_force", "tangential_force", "strength", "utilisation",
             "cell_minus", "cell_plus"):
    expect_equal(name, grid.fields[name],
                 columns("interfaces.csv", name)[:, 0])
expect_equal("ends", grid.points[grid.corners].reshape(-1, 6)[:, [0, 1, 3, 4]],
             columns("interfaces.csv", "x0", "y0", "x1", "y1"))

normals = columns("interfaces.csv", "nx", "ny")
tangents = normals[:, ::-1] * [-1, 1]
expect_equal("force", grid.fields["force"][:, :2],
             columns("interfaces.csv", "normal_force") * normals +
             columns("interfaces.csv", "tangential_force") * tangents)

# One polygon for each block, which shares no points.
blocks = read("blocks.vtu")
expect("fields of blocks.vtu", components(blocks.CellData),
       {"cell": 1, "group": 1, "load": 3, "stress": 9,
        "principal_stress_1": 1, "principal_stress_2": 1, "von_mises": 1,
        "torque": 1})
expect("point fields of blocks.vtu", components(blocks.PointData),
       {"displacement": 3})
grid = Grid(blocks)
grid.expect_types({"cell": "int32", "group": "int32"})
expect_equal("blocks", grid.fields["cell"], np.arange(n_cells))
expect_equal("points of blocks", grid.corners, np.arange(len(grid.points)))
if not np.allclose(grid.areas(), columns("cells.csv", "area")[:, 0],
                   rtol=1e-12):
    sys.exit("the polygons have not the areas of the blocks")
expect_equal("load", grid.fields["load"][:, :2],
             columns("cells.csv", "load_x", "load_y"))
expect_equal("mean stress", grid.fields["stress"][:, [0, 1, 3, 4]],
             columns("cells.csv", "sxx", "sxy", "syx", "syy"))
expect_equal("torque", grid.fields["torque"],
             columns("cells.csv", "torque")[:, 0])
expect_equal("displacement of blocks",
             grid.point_fields["displacement"][:, :2],
             columns("cells.csv", "ux", "uy")[grid.owner()])

# One after the other, the stress first.
together_reader = PVDReader(FileName=f"{directory}/results.pvd")
together_reader.UpdatePipelineInformation()
steps = list(together_reader.TimestepValues)
expect("steps of results.pvd", steps, [0, 1, 2])
for step, array in zip(steps, ("reconstructed", "load", "utilisation")):
    together_reader.UpdatePipeline(step)
    expect(f"step {step} of results.pvd",
           together_reader.CellData.GetArray(array) is not None, True)

stress = read("stress.vtu")
expect("fields of stress.vtu", components(stress.CellData),
       {"stress": 9, "principal_stress_1": 1, "principal_stress_2": 1,
        "von_mises": 1, "skew": 1, "div": 3, "cell": 1, "group": 1,
        "reconstructed": 1})
expect("point fields of stress.vtu", components(stress.PointData),
       {"displacement": 3})
# A side of the wall for each side of a cell: two per interface and one each
# for the boundary edges, 6 + 7 below and above and 12 on either side.
expect("sub-cells", stress.GetDataInformation().GetNumberOfCells(),
       2 * len(rows) + 6 + 7 + 24)
expect_range(stress, "cell", 0, 0, n_cells - 1)
expect_range(stress, "reconstructed", 0, 1, 1)
bounds = stress.GetDataInformation().GetBounds()
expect("bounds", [round(b, 6) for b in bounds], [0, 1, 0, 1, 0, 0])

grid = Grid(stress)
grid.expect_types({"cell": "int32", "group": "int32",
                   "reconstructed": "uint8"})
corners_of_cells = np.repeat(grid.fields["cell"], 4)
expect_equal("displacement",
             grid.point_fields["displacement"][grid.corners][:, :2],
             columns("cells.csv", "ux", "uy")[corners_of_cells])

# The sub-cells of a cell, whose areas add up to its own, share the centre.
quads = grid.points[grid.corners.reshape(-1, 4)][:, :, :2]
diagonals = quads[:, 2:] - quads[:, :2]
areas = 0.5 * (diagonals[:, 0, 0] * diagonals[:, 1, 1] -
               diagonals[:, 0, 1] * diagonals[:, 1, 0])
if not np.allclose(np.bincount(grid.fields["cell"], areas),
                   columns("cells.csv", "area")[:, 0], rtol=1e-12):
    sys.exit("the areas of sub-cells do not add up")
expect_equal("centres", quads[:, 0],
             columns("cells.csv", "x", "y")[grid.fields["cell"]])

# The courses slide on each other: the top one moves by one mean block, the
# root of 1/78, to the right and the bottom one to the left.
mechanism = read("mechanism.vtu", collapse)
expect("fields of mechanism.vtu", components(mechanism.CellData),
       {"cell": 1, "group": 1})
grid = Grid(mechanism)
expect_equal("blocks of the mechanism", grid.fields["cell"],
             np.arange(n_cells))
bounds = mechanism.GetDataInformation().GetBounds()
expect("bounds of the blocks at rest", [round(b, 6) for b in bounds],
       [0, 1, 0, 1, 0, 0])
displacement = grid.point_fields["displacement"]
expect("largest displacement", round(abs(displacement).max(), 6),
       round(78 ** -0.5, 6))
if abs(displacement[:, 1:]).max() > 1e-9:
    sys.exit("the courses do not slide, or not only")
top, bottom = displacement[-1, 0], displacement[0, 0]
expect("directions", (top > 0, bottom < 0), (True, True))

joints = read("mechanism_joints.vtu", collapse)
expect("fields of mechanism_joints.vtu", components(joints.CellData),
       {"opening": 1, "sliding": 1, "dissipation": 1})
grid = Grid(joints)
for name in ("opening", "sliding", "dissipation"):
    expect_equal(f"{name} of the mechanism", grid.fields[name],
                 columns("mechanism_joints.csv", name, directory=collapse)[:, 0])

# The stress [[-1, 0.3], [0.3, -2]] in every sub-cell.
stress = read("stress.vtu", uniform)
for component, value in {0: -1, 1: 0.3, 3: 0.3, 4: -2, 2: 0, 8: 0}.items():
    expect_range(stress, "stress", component, value, value)
expect_range(stress, "principal_stress_1", 0, -1.5 + 0.34 ** 0.5,
             -1.5 + 0.34 ** 0.5)

# The arch: its supports are lines to the cell -1, its keystone the second group.
interfaces = read("interfaces.vtu", arch)
expect_range(interfaces, "cell_plus", 0, -1, 20)
expect("lines of the arch",
       interfaces.GetDataInformation().GetNumberOfCells(), 22)
expect_range(read("stress.vtu", arch), "group", 0, 0, 1)
# Three processes write the same, each its own cells.
expect_pieces(Grid(read("stress.vtu", arch)), together)

# Values made up of the numbers of cell and sub-cell, whole and from pieces.
whole = Grid(read("stress.vtu", pieces))
cell = whole.fields["cell"].astype(float)
first = np.searchsorted(cell, cell)
side = np.arange(len(cell)) - first
zero = np.zeros(len(cell))
expect("cells of the pieces", len(np.unique(cell)), 30000)
expect_equal("stress", whole.fields["stress"].T,
             [1. / 3. + cell, side, zero, -1. * cell, 0.1 * side, zero,
              zero, zero, zero])
expect_equal("div", whole.fields["div"].T, [side, -0.1 * cell, zero])
expect_equal("skew", whole.fields["skew"], 0.7 * cell)
owner = np.repeat(cell, 4)
centre = np.repeat(np.reshape(whole.corners, (-1, 4)).min(axis=1), 4)
arm = whole.points[whole.corners] - whole.points[centre]
angle = 0.5 * (owner % 3)
expect_equal("displacement",
             whole.point_fields["displacement"][whole.corners].T,
             [1. / 3. + owner - angle * arm[:, 1],
              1. / 7. - owner + angle * arm[:, 0], np.zeros(len(owner))])
expect_equal("reconstructed", whole.fields["reconstructed"],
             (cell != 1) & (cell != 29999))
expect_pieces(whole, pieces)
print("ParaView reads the files")
