"""The shear wall's files, as ParaView's reader sees them, carried and not.

With +-1 along the top and bottom of 12 courses of 6 bricks, 78 in all, every
interface of a bed carries the tangential stress 1 and no normal stress.
"""
import csv
import sys

from paraview.simple import XMLUnstructuredGridReader

directory, collapse, uniform, arch = sys.argv[1:]


def read(name, directory=directory):
    reader = XMLUnstructuredGridReader(FileName=[f"{directory}/{name}"])
    reader.UpdatePipeline()
    return reader


def expect(what, found, expected):
    if found != expected:
        sys.exit(f"{what}: {found} found, {expected} expected")


def expect_range(reader, name, component, low, high):
    found = reader.PointData.GetArray(name).GetRange(component)
    if abs(found[0] - low) > 1e-6 or abs(found[1] - high) > 1e-6:
        sys.exit(f"{name}: {found} found, [{low}, {high}] expected")


def components(reader):
    return {reader.PointData.GetArray(i).Name:
            reader.PointData.GetArray(i).GetNumberOfComponents()
            for i in range(reader.PointData.GetNumberOfArrays())}


rows = list(csv.DictReader(open(f"{directory}/interfaces.csv")))
n_cells = len(list(csv.DictReader(open(f"{directory}/cells.csv"))))
expect("cells", n_cells, 78)

interfaces = read("interfaces.vtu")
expect("fields of interfaces.vtu", components(interfaces),
       {name: 1 for name in
        ("normal_force", "tangential_force", "normal_stress",
         "tangential_stress", "strength", "utilisation", "cell_minus",
         "cell_plus")})
info = interfaces.GetDataInformation()
expect("lines", info.GetNumberOfCells(), len(rows))
expect_range(interfaces, "normal_stress", 0, 0, 0)
expect_range(interfaces, "tangential_stress", 0, -1, 0)
expect_range(interfaces, "utilisation", 0, 0, 0.1)

stress = read("stress.vtu")
expect("fields of stress.vtu", components(stress),
       {"stress": 9, "principal_stress_1": 1, "principal_stress_2": 1,
        "von_mises": 1, "skew": 1, "div": 3, "cell": 1, "group": 1,
        "displacement": 3, "reconstructed": 1})
# A side of the wall for each side of a cell: two per interface and one each
# for the boundary edges, 6 + 7 below and above and 12 on either side.
expect("sub-cells", stress.GetDataInformation().GetNumberOfCells(),
       2 * len(rows) + 6 + 7 + 24)
expect_range(stress, "cell", 0, 0, n_cells - 1)
expect_range(stress, "reconstructed", 0, 1, 1)
bounds = stress.GetDataInformation().GetBounds()
expect("bounds", [round(b, 6) for b in bounds], [0, 1, 0, 1, 0, 0])

# The courses slide on each other: the top one moves by one mean block, the
# root of 1/78, to the right and the bottom one to the left.
mechanism = read("mechanism.vtu", collapse)
expect("fields of mechanism.vtu", components(mechanism),
       {"displacement": 3, "cell": 1})
expect("sub-cells of mechanism.vtu",
       mechanism.GetDataInformation().GetNumberOfCells(),
       2 * len(rows) + 6 + 7 + 24)
block = 78 ** -0.5
expect_range(mechanism, "displacement", 1, 0, 0)
low, high = mechanism.PointData.GetArray("displacement").GetRange(0)
expect("largest displacement", round(max(-low, high), 6), round(block, 6))
bounds = mechanism.GetDataInformation().GetBounds()
expect("bounds of the moved blocks", [round(b, 5) for b in bounds],
       [round(b, 5) for b in (low, 1 + high, 0, 1, 0, 0)])

# The stress [[-1, 0.3], [0.3, -2]] in every sub-cell.
stress = read("stress.vtu", uniform)
for component, value in {0: -1, 1: 0.3, 3: 0.3, 4: -2, 2: 0, 8: 0}.items():
    expect_range(stress, "stress", component, value, value)
expect_range(stress, "principal_stress_1", 0, -1.5 + 0.34 ** 0.5,
             -1.5 + 0.34 ** 0.5)
print("ParaView reads the files")

# The arch: its supports are lines to the cell -1, its keystone the second group.
interfaces = read("interfaces.vtu", arch)
expect_range(interfaces, "cell_plus", 0, -1, 20)
expect("lines of the arch",
       interfaces.GetDataInformation().GetNumberOfCells(), 22)
expect_range(read("stress.vtu", arch), "group", 0, 0, 1)
