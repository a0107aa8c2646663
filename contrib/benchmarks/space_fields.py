"""Stresses in closed form, as loads of one block and as functions, and how far
a stress that was found in a block is from them.

Points are arrays (n, 3), stresses (n, 3, 3).
"""
import math

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

# The ring is between the radii one and two, under the pressure one inside
# (Lame): sigma_rr = A - B / r^2, sigma_tt = A + B / r^2 in the plane of x and y.
A, B = 1 / 3, 4 / 3
PLACE = 1.45, 0., 0.  # the middle of a block

# Each by its components on or above the diagonal, expressions that both the
# program and Python read, and the body force.
_R2 = "(x*x + y*y)"
FIELDS = {
    "uniform": ({"xx": "-1.3", "xy": "0.2", "xz": "0.1", "yy": "-0.7",
                 "yz": "-0.3", "zz": "-1"}, (0, 0, 0)),
    "column under its weight": ({"zz": "z - 2"}, (0, 0, -1)),
    "bar in bending": ({"xx": "z - 1"}, (0, 0, 0)),
    "thick ring": ({"xx": f"{A!r} - {B!r}*(x*x - y*y)/{_R2}/{_R2}",
                    "xy": f"-{2 * B!r}*x*y/{_R2}/{_R2}",
                    "yy": f"{A!r} + {B!r}*(x*x - y*y)/{_R2}/{_R2}"}, (0, 0, 0)),
}


def component(name, i, j):
    """The expression of a component of a field."""
    return FIELDS[name][0].get("".join(sorted("xyz"[i] + "xyz"[j])), "0")


def loads(name):
    """The tractions of a field on all faces of a block, and its body force."""
    traction = "; ".join(
        " + ".join(f"({component(name, i, j)})*{normal}"
                   for j, normal in enumerate(("nx", "ny", "nz")))
        for i in range(3))
    return {"Loads/Traction": traction,
            "Loads/Body force": "; ".join(map(str, FIELDS[name][1]))}


def exact(name, points):
    """The stress of a field."""
    x, y, z = points.T
    stress = np.empty((len(points), 3, 3))
    for i in range(3):
        for j in range(3):
            stress[:, i, j] = eval(component(name, i, j),
                                   {"x": x, "y": y, "z": z})
    return stress


def quadrature(tetrahedra):
    """Points (n, q, 3) and weights (n, q) in tetrahedra (n, 4, 3), exact for
    polynomials of degree five."""
    t, w = np.polynomial.legendre.leggauss(4)
    t, w = (t + 1) / 2, w / 2
    a, b, c = (g.ravel() for g in np.meshgrid(t, t, t, indexing="ij"))
    weight = np.einsum("i,j,k->ijk", w, w, w).ravel() * (1 - a)**2 * (1 - b)
    shape = np.stack([a, (1 - a) * b, (1 - a) * (1 - b) * c], axis=1)
    edges = tetrahedra[:, 1:] - tetrahedra[:, :1]
    points = tetrahedra[:, :1] + np.einsum("qi,nix->nqx", shape, edges)
    return points, np.abs(np.linalg.det(edges))[:, None] * weight


def cut(vertices, faces):
    """The tetrahedra (n, 4, 3) between the origin's image, the mean of the
    vertices, and the triangles of the faces."""
    centre = vertices.mean(axis=0)
    return np.array([[centre, *vertices[[face[0], *face[k:k + 2]]]]
                     for face in faces for k in range(1, len(face) - 1)])


def grid(path):
    """A .vtu file."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def tensors(data, name):
    """The tensors of an array of a .vtu file, (n, 3, 3)."""
    return vtk_to_numpy(data.GetArray(name)).reshape(-1, 3, 3)


def pieces(directory, vertices, faces):
    """Of the stress of one block in the results of a run: tetrahedra
    (n, 4, 3), and in them the coefficients (n, 4, 3, 3) of one and of the
    coordinates."""
    if (directory / "stress.vtu").exists():
        found = grid(directory / "stress.vtu")
        corners = vtk_to_numpy(found.GetCells().GetConnectivityArray())
        points = vtk_to_numpy(found.GetPoints().GetData())
        stress = tensors(found.GetCellData(), "stress")
        constant = np.zeros((len(stress), 4, 3, 3))
        constant[:, 0] = stress
        return points[corners.reshape(-1, 4)], constant
    block = grid(directory / "blocks.vtu")
    tetrahedra = cut(vertices, faces)
    if block.GetPointData().HasArray("stress"):
        points = vtk_to_numpy(block.GetPoints().GetData())
        values = tensors(block.GetPointData(), "stress").reshape(-1, 9)
        basis = np.column_stack([np.ones(len(points)), points])
        of_all = np.linalg.lstsq(basis, values, rcond=None)[0]
    else:
        of_all = np.zeros((4, 9))
        of_all[0] = tensors(block.GetCellData(), "mean_stress")[0].ravel()
    return tetrahedra, np.tile(of_all.reshape(4, 3, 3),
                               (len(tetrahedra), 1, 1, 1))


def distance(name, directory, vertices, faces):
    """The L2 distance of the stress that was found to the field, over the
    largest stress of the field in the block; and that of the mean stress."""
    tetrahedra, coefficients = pieces(directory, vertices, faces)
    points, weights = quadrature(tetrahedra)
    basis = np.concatenate([np.ones((*points.shape[:2], 1)), points], axis=2)
    found = np.einsum("nqk,nkij->nqij", basis, coefficients)
    change = found - exact(name, points.reshape(-1, 3)).reshape(found.shape)
    volume = weights.sum()
    size = np.abs(exact(name, vertices)).max()
    mean = np.einsum("nq,nqij->ij", weights, change) / volume
    square = np.einsum("nq,nqij->", weights, change**2) / volume
    return math.sqrt(square) / size, np.linalg.norm(mean) / size
