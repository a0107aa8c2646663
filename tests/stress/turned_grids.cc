// SPDX-License-Identifier: LGPL-2.1-or-later

// The patch test of all accuracies on Voronoi cells of square grids that are
// turned and rounded to 6 to 14 decimals. Four cells that should meet in a
// point then have sides between them as short as the last decimal. A uniform
// stress comes back in every sub-cell, and no cell is given up, with the forces
// of that stress and with those of least energy, which on a short side have the
// rounding of the whole cell. Loads that slide and tip leave the equations met.

#include <voussoir/stress/cell_means.h>
#include <voussoir/stress/reconstruction.h>

#include "tests.h"

using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** The cells of a grid with 1/n between its points, turned by an angle. */
Packing
turned_grid(const int n, const double angle, const unsigned int decimals)
{
  const double unit = std::pow(10., decimals);
  const auto round = [&](const double x) {
    return std::round(x * unit) / unit;
  };
  PointList list;
  for (int i = -n; i < n; ++i)
    for (int j = -n; j < n; ++j)
    {
      const double x = (i + 0.5) / n, y = (j + 0.5) / n;
      const Point<2> p(round(0.5 + std::cos(angle) * x - std::sin(angle) * y),
                       round(0.5 + std::sin(angle) * x + std::cos(angle) * y));
      if (std::abs(p[0] - 0.5) < 0.49 && std::abs(p[1] - 0.5) < 0.49)
        list.points.push_back(p);
    }
  return Packing(voronoi_cells(list, {{0, 0}, {1, 1}}));
}

/** The forces of a uniform stress. */
InterfaceForces forces_of(const Scene &scene, const Tensor<2, 2> &S)
{
  InterfaceForces forces;
  for (const auto &interface : scene.packing.interfaces())
  {
    const Tensor<1, 2> f = interface.length * (S * interface.normal);
    forces.normal.push_back(f * interface.normal);
    forces.tangential.push_back(f * interface.tangent());
  }
  return forces;
}

double largest_error(const Scene &scene,
                     const InterfaceForces &forces,
                     const Tensor<2, 2> &S,
                     const Reconstruction &how)
{
  double error = 0.;
  const StressField field =
      reconstruct_stress(scene, forces, how, Terminal::silent());
  for (const SubCellStress &sub_cell : field.sub_cells)
    error = std::max(error, (sub_cell.stress - S).norm());
  return field.undetermined.empty() ? error : HUGE_VAL;
}

struct Grid
{
  int n;
  double angle;
};

int main()
{
  const Tensor<2, 2> S = tensor(-1.2, 0.3, 0.3, -0.8);
  const double bound = 1e-6;
  Solver solver(least_energy);
  for (const Grid &grid : {Grid{8, 0.3}, Grid{5, 0.7}, Grid{11, 0.123}})
  {
    std::cout << 1. / grid.n << " apart, turned by " << grid.angle << std::endl;
    double shortest = 1., of_means = 0., of_standard = 0., of_fine[2][3] = {};
    for (unsigned int decimals = 6; decimals <= 14; ++decimals)
    {
      const Scene scene =
          scene_under_stress(turned_grid(grid.n, grid.angle, decimals), 5., S);
      for (const auto &interface : scene.packing.interfaces())
        shortest = std::min(shortest, interface.length);
      for (const InterfaceForces &forces :
           {forces_of(scene, S), solver.forces(scene)})
      {
        for (const Tensor<2, 2> &mean : cell_mean_stresses(scene, forces))
          of_means = std::max(of_means, (mean - S).norm());
        of_standard =
            std::max(of_standard, largest_error(scene, forces, S, {}));
        for (const unsigned int degree : {0U, 1U})
          for (unsigned int n = 0; n < 3; ++n)
            // The largest systems on the smallest grid are enough.
            if (degree + n < 3 || grid.n < 8)
              of_fine[degree][n] =
                  std::max(of_fine[degree][n],
                           largest_error(scene, forces, S, {true, n, degree}));
      }
    }
    check("  sides are as short as rounding", shortest < 1e-11);
    check_error("  draft", of_means, bound);
    check_error("  standard", of_standard, bound);
    for (const unsigned int degree : {0U, 1U})
      for (const unsigned int n : {0U, 1U, 2U})
        check_error("  fine, degree " + std::to_string(degree) + ", " +
                        std::to_string(n) + " refinements",
                    of_fine[degree][n], bound);
  }

  // Not uniform: the stress is that on the grid with all digits, in which four
  // cells meet, to what the decimals change. Area-weighted means in each cell.
  const auto means_of = [&](const unsigned int decimals,
                            const Reconstruction &how) {
    const Scene scene =
        scene_with(turned_grid(8, 0.3, decimals), 0.35,
                   [](const Point<2> &x, const Tensor<1, 2> &n) {
                     return tensor(-1.4 + x[1], 0.1, 0.1, -0.9 + x[0]) * n;
                   });
    const InterfaceForces forces = solver.forces(scene);
    const StressField field =
        reconstruct_stress(scene, forces, how, solver.quiet);
    check("  no cell given up", field.undetermined.empty());
    std::vector<double> largest(scene.packing.n_cells());
    for (unsigned int c = 0; c < largest.size(); ++c)
      for (std::size_t k = field.first(scene.packing, c, 0);
           k < field.first(scene.packing, c + 1, 0); ++k)
        largest[c] = std::max(largest[c], field.sub_cells[k].stress.norm());
    return largest;
  };
  for (const Reconstruction &how :
       {Reconstruction(), Reconstruction{true, 0, 0},
        Reconstruction{true, 0, 1}, Reconstruction{true, 1, 0}})
  {
    std::cout << (how.is_refined ? "fine" : "standard") << ", uneven, degree "
              << how.degree << ", " << how.n_refinements << " refinements"
              << std::endl;
    const std::vector<double> exact = means_of(14, how),
                              few = means_of(10, how);
    double difference = 0.;
    for (unsigned int c = 0; c < exact.size(); ++c)
      difference = std::max(difference, std::abs(exact[c] - few[c]) / exact[c]);
    check_error("  the largest stress in each cell", difference, 1e-6);
  }
}
