"""The files of packings in space, as ParaView's reader sees them.

VTK measures the polyhedra and the polygons by code of its own: volumes and areas
must be those of the fields, of the tables and of the summary.
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


def expect(what, holds):
    if not holds:
        sys.exit(f"{what} is not as expected")


def expect_close(what, found, expected):
    """Equal but for the single precision that VTK has volumes in."""
    error = np.max(np.abs(found - expected)) / np.max(np.abs(expected))
    if not error < 1e-5:
        sys.exit(f"{what}: differs by {error}")


def check(directory):
    summary = json.load(open(f"{directory}/summary.json"))["packing"]
    blocks = read(f"{directory}/blocks.vtu")
    n = summary["cells"] + summary["fixed_cells"]
    expect(f"the number of blocks in {directory}", blocks.GetNumberOfCells() == n)
    expect(f"the shape of blocks in {directory}",
           all(blocks.GetCellType(c) == POLYHEDRON for c in range(n)))
    expect_close(f"volumes in {directory}", array(blocks, "Volume"),
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
