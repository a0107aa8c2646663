"""How accurate results are, computed from interfaces.csv, cells.csv and
stress.vtu alone.

Arrays have a line per interface, cell or sub-cell; vectors have the shape
(n, 2) and stresses (n, 2, 2).
"""
import copy

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy


def columns(path, names):
    """The named columns of a .csv file, an array each."""
    with open(path, encoding="utf-8") as file:
        header = file.readline().strip().split(",")
    table = np.loadtxt(path, delimiter=",", skiprows=1, ndmin=2,
                       usecols=[header.index(name) for name in names])
    return dict(zip(names, table.T))


class State:
    """The forces of a run that wrote .csv files."""

    def __init__(self, directory):
        e = columns(directory / "interfaces.csv", [
            "cell_minus", "cell_plus", "x0", "y0", "x1", "y1", "nx", "ny",
            "length", "normal_force", "tangential_force", "strength"])
        c = columns(directory / "cells.csv", [
            "x", "y", "load_x", "load_y", "area", "sxx", "sxy", "syx", "syy"])
        self.minus = e["cell_minus"].astype(int)
        self.plus = e["cell_plus"].astype(int)
        self.length, self.strength = e["length"], e["strength"]
        self.normal = np.stack([e["nx"], e["ny"]], axis=1)
        self.middle = np.stack(
            [e["x0"] + e["x1"], e["y0"] + e["y1"]], axis=1) / 2
        self.normal_force = e["normal_force"]
        self.tangential_force = e["tangential_force"]
        self.centre = np.stack([c["x"], c["y"]], axis=1)
        self.load = np.stack([c["load_x"], c["load_y"]], axis=1)
        self.area = c["area"]
        self.mean_stress = np.stack(
            [c["sxx"], c["sxy"], c["syx"], c["syy"]], axis=1).reshape(-1, 2, 2)

    def with_forces(self, normal_force, tangential_force):
        """The same packing and loads with other forces."""
        other = copy.copy(self)
        other.normal_force = normal_force
        other.tangential_force = tangential_force
        return other

    @property
    def force(self):
        """The force of each interface on cell_minus."""
        tangent = np.stack([-self.normal[:, 1], self.normal[:, 0]], axis=1)
        return (self.normal_force[:, None] * self.normal +
                self.tangential_force[:, None] * tangent)

    @property
    def largest_load(self):
        """The reference force: the largest load on a cell of the scene."""
        return np.linalg.norm(self.load, axis=1).max()

    def residual(self):
        """The largest sum of all forces on a cell, over the reference force."""
        total = self.load.copy()
        for cell, sign in ((self.minus, 1), (self.plus, -1)):
            on_cell = cell >= 0
            np.add.at(total, cell[on_cell], sign * self.force[on_cell])
        return np.linalg.norm(total, axis=1).max() / self.largest_load

    def violation(self):
        """The largest f_n or |f_t| - s |e| above zero, over the reference
        force."""
        excess = np.maximum(
            self.normal_force,
            np.abs(self.tangential_force) - self.strength * self.length)
        return max(excess.max(), 0.) / self.largest_load

    def norm(self, force):
        """The root of sum_e d_e / |e| |force_e|^2; d_e is the distance of the
        centres along the normal, to a support that of its middle."""
        minus = np.where((self.minus >= 0)[:, None], self.centre[self.minus],
                         self.middle)
        plus = np.where((self.plus >= 0)[:, None], self.centre[self.plus],
                        self.middle)
        distance = np.abs(np.sum((plus - minus) * self.normal, axis=1))
        return np.sqrt(np.sum(distance / self.length *
                              np.sum(force**2, axis=1)))

    def distance(self, reference):
        """Of the forces to those of another State, relative to those."""
        return (self.norm(self.force - reference.force) /
                self.norm(reference.force))

    def patch_error(self, stress):
        """The distance of the forces to those of a uniform stress (2, 2)."""
        exact = self.normal @ np.asarray(stress) * self.length[:, None]
        return self.norm(self.force - exact) / self.norm(exact)

    def change_of_mean_stress(self, reference):
        """The root mean square over the cells, by area, of the change of their
        mean stress from another State's, relative to those."""
        weight = self.area[:, None, None]
        change = np.sum(weight * (self.mean_stress - reference.mean_stress)**2)
        return np.sqrt(change / np.sum(weight * reference.mean_stress**2))


class Field:
    """A stress that is constant in each sub-cell: `stress`, the `area` of the
    sub-cell and the number of the `cell` that it is in."""

    def __init__(self, stress, area, cell):
        self.stress, self.area, self.cell = stress, area, cell

    def norm(self, stress):
        """The L2 norm of a stress that is constant in each sub-cell."""
        return np.sqrt(np.sum(self.area[:, None, None] * stress**2))

    def patch_error(self, stress):
        """The L2 distance to a uniform stress (2, 2), relative to it."""
        exact = np.broadcast_to(np.asarray(stress), self.stress.shape)
        return self.norm(self.stress - exact) / self.norm(exact)

    def distances(self, finer):
        """The L2 distances to a StressField of the same packing, relative to
        that field: of the stress as it is, and of its means over the sub-cells
        of this one."""
        here = self.located(finer)
        found, here = here >= 0, here[here >= 0]
        exact, area = finer.stress[found], finer.area[found]
        weighted = (area[:, None, None] * exact).reshape(-1, 4)
        covered = np.bincount(here, area, len(self.area))
        means = np.stack([np.bincount(here, column, len(self.area))
                          for column in weighted.T], axis=1)
        means /= np.maximum(covered, 1e-300)[:, None]
        change = self.stress[here] - exact
        change_of_means = self.stress[here] - means.reshape(-1, 2, 2)[here]
        return [np.sqrt(np.sum(area[:, None, None] * field**2)) /
                finer.norm(finer.stress) for field in (change, change_of_means)]


class MeanStress(Field):
    """The mean stress of each cell, of cells.csv."""

    def __init__(self, directory):
        c = columns(directory / "cells.csv",
                    ["area", "sxx", "sxy", "syx", "syy"])
        stress = np.stack([c[name] for name in ("sxx", "sxy", "syx", "syy")], 1)
        super().__init__(stress.reshape(-1, 2, 2), c["area"],
                         np.arange(len(stress)))

    def located(self, finer):
        """Which of its cells each sub-cell of another field is in."""
        return finer.cell


class StressField(Field):
    """The sub-cells of a stress.vtu. The centroids are `middle`, (n, 2)."""

    def __init__(self, directory):
        reader = vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(directory / "stress.vtu"))
        reader.Update()
        self.grid = reader.GetOutput()
        corners = vtk_to_numpy(
            self.grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
        points = vtk_to_numpy(self.grid.GetPoints().GetData())
        values = self.grid.GetCellData()

        def at(name):
            return vtk_to_numpy(values.GetArray(name))

        self.middle, area = centroids(points[corners, :2])
        super().__init__(in_plane(at("stress")), area, at("cell").astype(int))
        self.div, self.skew = at("div")[:, :2], at("skew")

    def imbalance(self, body_force):
        """The L2 norm of (div sigma + b) times the root of the cell's area,
        over that of sigma; and of what is left of it without the rigid
        acceleration of each cell about its centroid."""
        def total(weight):
            return np.bincount(self.cell, weight * self.area)

        left = self.div + np.asarray(body_force)
        cell_area = total(1.)
        centre = np.stack([total(x) for x in self.middle.T], axis=1)
        centre /= cell_area[:, None]
        arm = self.middle - centre[self.cell]
        turned = np.stack([-arm[:, 1], arm[:, 0]], axis=1)
        spin = (total(np.sum(turned * left, axis=1)) /
                total(np.sum(turned**2, axis=1)))
        rest = left - spin[self.cell, None] * turned
        return [np.sqrt(np.sum(cell_area * total(np.sum(field**2, axis=1)))) /
                self.norm(self.stress) for field in (left, rest)]

    def asymmetry(self):
        """The L2 norm of the skew part of sigma over that of sigma."""
        return (np.sqrt(2 * np.sum(self.area * self.skew**2)) /
                self.norm(self.stress))

    def located(self, finer):
        """Which of its sub-cells the middle of each one of another field is in,
        or -1 where rounding hides it, on the rim of a sliver."""
        number = numpy_to_vtk(np.arange(float(len(self.area))))
        number.SetName("number")
        source = vtk.vtkUnstructuredGrid()
        source.CopyStructure(self.grid)
        source.GetCellData().AddArray(number)
        points = vtk.vtkPoints()
        points.SetData(numpy_to_vtk(np.pad(finer.middle, ((0, 0), (0, 1)))))
        middles = vtk.vtkPolyData()
        middles.SetPoints(points)
        probe = vtk.vtkProbeFilter()
        probe.SetInputData(middles)
        probe.SetSourceData(source)
        probe.Update()
        found = probe.GetOutput().GetPointData()
        hit = vtk_to_numpy(found.GetArray("vtkValidPointMask")) > 0
        return np.where(hit, np.rint(vtk_to_numpy(found.GetArray("number"))),
                        -1).astype(int)


def in_plane(tensors):
    """The components xx, xy, yx, yy of tensors with nine, as (n, 2, 2)."""
    return tensors[:, [0, 1, 3, 4]].reshape(-1, 2, 2)


def centroids(quads):
    """The centroids (n, 2) and areas (n) of quadrilaterals (n, 4, 2)."""
    first, area = 0., 0.
    for a, b, c in ((0, 1, 2), (0, 2, 3)):
        u, v = quads[:, b] - quads[:, a], quads[:, c] - quads[:, a]
        part = (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2
        first = first + part[:, None] * (quads[:, a] + (u + v) / 3)
        area = area + part
    return first / area[:, None], np.abs(area)
