// SPDX-License-Identifier: LGPL-2.1-or-later

// The patch test of all accuracies on Voronoi cells of square grids that are
// turned and rounded to 6 to 14 decimals. Four cells that should meet in a
// point then have sides between them as short as the last decimal. A uniform
// stress comes back in every sub-cell, and no cell is given up, with the forces
// of that stress and with those of least energy, which on a short side have the
// rounding of the whole cell. So does an uneven one, up to the last decimal.

#include <voussoir/stress/cell_means.h>
#include <voussoir/stress/reconstruction.h>

#include "tests.h"

namespace test_turned_grids
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** The cells of a grid with 1/n between its points, turned by an angle. */
Packing<2>
turned_grid(const int n, const double angle, const unsigned int decimals)
{
  const double unit = std::pow(10., decimals);
  const auto round = [&](const double x) {
    return std::round(x * unit) / unit;
  };
  PointList<2> list;
  for (int i = -n; i < n; ++i)
    for (int j = -n; j < n; ++j)
    {
      const double x = (i + 0.5) / n, y = (j + 0.5) / n;
      const Point<2> p(round(0.5 + std::cos(angle) * x - std::sin(angle) * y),
                       round(0.5 + std::sin(angle) * x + std::cos(angle) * y));
      if (std::abs(p[0] - 0.5) < 0.49 && std::abs(p[1] - 0.5) < 0.49)
        list.points.push_back(p);
    }
  return Packing<2>(voronoi_cells(list, {{0, 0}, {1, 1}}));
}

/** The forces of a stress with the given mean on an edge. */
template <typename Stress>
InterfaceForces forces_of(const Scene &scene, const Stress &stress)
{
  InterfaceForces forces;
  for (const auto &interface : scene.packing.interfaces())
  {
    const Tensor<1, 2> f =
        interface.length * (stress(interface.midpoint()) * interface.normal);
    forces.normal.push_back(f * interface.normal);
    forces.tangential.push_back(f * interface.tangent());
  }
  return forces;
}

/** A scene under the tractions of a stress. */
template <typename Stress>
Scene scene_with_stress(Packing<2> packing,
                        const double s_T,
                        const Stress &stress)
{
  return scene_with(
      std::move(packing), s_T,
      [&](const Point<2> &x, const Tensor<1, 2> &n) { return stress(x) * n; });
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

/** The largest stress in each cell; no cell may be given up. */
std::vector<double> largest_stresses(const Scene &scene,
                                     const InterfaceForces &forces,
                                     const Reconstruction &how)
{
  const StressField field =
      reconstruct_stress(scene, forces, how, Terminal::silent());
  std::vector<double> largest(scene.packing.n_cells());
  for (unsigned int c = 0; c < largest.size(); ++c)
    for (std::size_t k = field.first(scene.packing, c, 0);
         k < field.first(scene.packing, c + 1, 0); ++k)
      largest[c] = std::max(largest[c], field.sub_cells[k].stress.norm());
  for (const unsigned int c : field.undetermined)
    largest[c] = HUGE_VAL;
  return largest;
}

double relative_difference(const std::vector<double> &a,
                           const std::vector<double> &b)
{
  double difference = 0.;
  for (unsigned int c = 0; c < a.size(); ++c)
    difference = std::max(difference, std::abs(a[c] - b[c]) / a[c]);
  return difference;
}

std::string name_of(const Reconstruction &how)
{
  return how.is_refined ? "fine, degree " + std::to_string(how.degree) + ", " +
                              std::to_string(how.n_refinements) + " refinements"
                        : "standard";
}

struct Grid
{
  int n;
  double angle;
  std::vector<Reconstruction> ways;
};

void check_uniform(const Grid &grid)
{
  const Tensor<2, 2> S = tensor(-1.2, 0.3, 0.3, -0.8);
  const double bound = 1e-6;
  Solver solver(least_energy);
  std::cout << "1/" << grid.n << " apart, turned by " << grid.angle
            << std::endl;
  double shortest = 1., of_means = 0.;
  std::vector<double> errors(grid.ways.size());
  for (unsigned int decimals = 6; decimals <= 14; ++decimals)
  {
    const Scene scene =
        scene_under_stress(turned_grid(grid.n, grid.angle, decimals), 5., S);
    for (const auto &interface : scene.packing.interfaces())
      shortest = std::min(shortest, interface.length);
    for (const InterfaceForces &forces :
         {forces_of(scene, [&](const Point<2> &) { return S; }),
          solver.forces(scene)})
    {
      for (const Tensor<2, 2> &mean : cell_mean_stresses(scene, forces))
        of_means = std::max(of_means, (mean - S).norm());
      for (unsigned int k = 0; k < errors.size(); ++k)
        errors[k] =
            std::max(errors[k], largest_error(scene, forces, S, grid.ways[k]));
    }
  }
  check("  sides are as short as rounding", shortest < 1e-11);
  check_error("  draft", of_means, bound);
  for (unsigned int k = 0; k < errors.size(); ++k)
    check_error("  " + name_of(grid.ways[k]), errors[k], bound);
}

void run()
{
  const Reconstruction standard, coarse = {true, 0, 0}, rich = {true, 0, 1},
                                 finer = {true, 1, 0};
  // The largest systems on the smallest grid.
  for (const Grid &grid : {Grid{8, 0.3, {standard, coarse, rich}},
                           Grid{5,
                                0.7,
                                {standard,
                                 coarse,
                                 rich,
                                 finer,
                                 {true, 1, 1},
                                 {true, 2, 0},
                                 {true, 2, 1}}},
                           Grid{11, 0.123, {standard, coarse}}})
    check_uniform(grid);

  // An uneven stress with a torque in each cell, and one in which joints slide
  // and least energy has the last word: as on the grid with all digits, where
  // four cells meet.
  const auto uneven = [](const Point<2> &x) {
    return tensor(-2. + 2. * x[1], -x[0] - 0.1, -x[0] + 0.1, -3. + x[0] + x[1]);
  };
  const auto sliding = [](const Point<2> &x) {
    return tensor(-1.4 + x[1], 0.1, 0.1, -0.9 + x[0]);
  };
  Solver solver(least_energy);
  for (const Reconstruction &how : {standard, coarse, rich, finer})
  {
    std::cout << name_of(how) << std::endl;
    std::vector<double> under_uneven[2], under_sliding[2];
    for (const unsigned int k : {0U, 1U})
    {
      const unsigned int decimals = k == 0 ? 14 : 10;
      const Scene scene =
          scene_with_stress(turned_grid(8, 0.3, decimals), 5., uneven);
      under_uneven[k] = largest_stresses(scene, forces_of(scene, uneven), how);
      const Scene slides =
          scene_with_stress(turned_grid(8, 0.3, decimals), 0.35, sliding);
      under_sliding[k] = largest_stresses(slides, solver.forces(slides), how);
    }
    check_error("  uneven, with torques",
                relative_difference(under_uneven[0], under_uneven[1]), 1e-6);
    // The forces themselves differ, in all accuracies alike.
    check_error("  sliding",
                relative_difference(under_sliding[0], under_sliding[1]), 1e-4);
  }
}

const RoomTest test("turned_grids", run);
} // namespace test_turned_grids
