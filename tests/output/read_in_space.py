"""The files of packings in space, as ParaView's reader sees them.

Volumes from the faces that VTK sees, and areas that it measures, must be those of
the fields, of the tables and of the summary.
"""
import csv
import json
import sys

import numpy as np
from paraview.servermanager import Fetch
from paraview.simple import CellSize, PVDReader, XMLUnstructuredGridReader
from vtk.util.numpy_support import vtk_to_numpy

POLYGON, POLYHEDRON = 7, 42


def read(path):
    """The grid of a file with what VTK measures of its cells."""
    return Fetch(CellSize(Input=XMLUnstructuredGridReader(FileName=[path])))


def array(grid, name):
    return vtk_to_numpy(grid.GetCellData().GetArray(name))


def column(path, name):
    return np.array([float(row[name]) for row in csv.DictReader(open(path))])


def volume(polyhedron):
    """By the divergence theorem, of faces that run outwards, convex or not."""
    total = 0.
    origin = np.array(polyhedron.GetPoints().GetPoint(0))
    for f in range(polyhedron.GetNumberOfFaces()):
        points = vtk_to_numpy(polyhedron.GetFace(f).GetPoints().GetData()) - origin
        for one, other in zip(points[1:], points[2:]):
            total += points[0].dot(np.cross(one, other)) / 6
    return total


def expect(what, holds):
    if not holds:
        sys.exit(f"{what} is not as expected")


def expect_close(what, found, expected):
    """Equal but for the rounding of sums."""
    error = np.max(np.abs(found - expected)) / np.max(np.abs(expected))
    if not error < 1e-9:
        sys.exit(f"{what}: differs by {error}")


def check(directory):
    summary = json.load(open(f"{directory}/summary.json"))["packing"]
    blocks = read(f"{directory}/blocks.vtu")
    n = summary["cells"] + summary["fixed_cells"]
    expect(f"the number of blocks in {directory}", blocks.GetNumberOfCells() == n)
    expect(f"the shape of blocks in {directory}",
           all(blocks.GetCellType(c) == POLYHEDRON for c in range(n)))
    expect_close(f"volumes in {directory}",
                 np.array([volume(blocks.GetCell(c)) for c in range(n)]),
                 array(blocks, "volume"))
    expect(f"cells.csv in {directory}",
           np.array_equal(column(f"{directory}/cells.csv", "volume"),
                          array(blocks, "volume")))
    expect_close(f"the volume of {directory}",
                 array(blocks, "volume")[array(blocks, "fixed") == 0].sum(),
                 summary["volume"])
    faces = sum(blocks.GetCell(c).GetNumberOfFaces() for c in range(n))
    expect(f"faces in {directory}", array(blocks, "faces").sum() == faces)

    joints = read(f"{directory}/interfaces.vtu")
    n = summary["interfaces"]
    expect(f"the number of joints in {directory}", joints.GetNumberOfCells() == n)
    expect(f"the shape of joints in {directory}",
           all(joints.GetCellType(e) == POLYGON for e in range(n)))
    expect_close(f"areas in {directory}", array(joints, "Area"),
                 array(joints, "area"))
    expect(f"interfaces.csv in {directory}",
           np.array_equal(column(f"{directory}/interfaces.csv", "area"),
                          array(joints, "area")))
    expect(f"distances in {directory}", array(joints, "distance").min() > 0)

    # The vector areas of all faces of the blocks that move add up to nothing.
    tables = {name: list(csv.DictReader(open(f"{directory}/{name}.csv")))
              for name in ("interfaces", "boundary")}
    sums = np.zeros((summary["cells"], 3))
    area = 0.
    for row in tables["interfaces"]:
        normal = np.array([float(row[k]) for k in ("nx", "ny", "nz")])
        vector = float(row["area"]) * normal
        sums[int(row["cell_minus"])] += vector
        if row["support"] == "0":
            sums[int(row["cell_plus"])] -= vector
        area = max(area, float(row["area"]))
    for row in tables["boundary"]:
        normal = np.array([float(row[k]) for k in ("nx", "ny", "nz")])
        sums[int(row["cell"])] += float(row["area"]) * normal
        area = max(area, float(row["area"]))
    expect(f"closed blocks in {directory}", np.max(np.abs(sums)) < 1e-9 * area)

    collection = PVDReader(FileName=f"{directory}/results.pvd")
    expect(f"the grids in {directory}", len(collection.TimestepValues) == 2)


for directory in sys.argv[1:]:
    check(directory)
print("OK")
