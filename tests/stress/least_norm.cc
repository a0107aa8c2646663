// SPDX-License-Identifier: LGPL-2.1-or-later

// The refined reconstruction. Where the forces leave no torque, div sigma = 0
// in every sub-cell, also in cells with many sides, for which the paper's fan
// has too few fluxes. Where they do, div sigma is the rigid acceleration of a
// block of unit density. The error of the stress against that of a finer mesh
// falls by refinement.

#include <voussoir/base/geometry.h>
#include <voussoir/stress/fan.h>
#include <voussoir/stress/least_norm.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include "tests.h"

namespace test_least_norm
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** An irregular polygon with n sides around the origin. */
std::vector<Point<2>> polygon(const unsigned int n,
                              boost::random::mt19937 &random)
{
  boost::random::uniform_real_distribution<double> shift(-0.3, 0.3);
  std::vector<Point<2>> vertices;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double angle = 2. * dealii::numbers::PI * (i + shift(random)) / n;
    vertices.emplace_back(1.3 * std::cos(angle), std::sin(angle));
  }
  return vertices;
}

/** Random forces that balance, with the given torque about the origin. */
std::vector<Tensor<1, 2>> balanced_forces(const std::vector<Point<2>> &vertices,
                                          const double torque,
                                          boost::random::mt19937 &random)
{
  boost::random::uniform_real_distribution<double> any(-1., 1.);
  const unsigned int n = vertices.size();
  std::vector<Tensor<1, 2>> forces(n), middles(n);
  Tensor<1, 2> resultant, mean_middle;
  for (unsigned int i = 0; i < n; ++i)
  {
    forces[i] = Tensor<1, 2>({any(random), any(random)});
    middles[i] = 0.5 * (vertices[i] + vertices[(i + 1) % n]);
    resultant += forces[i];
    mean_middle += middles[i] / n;
  }
  double moment = 0., inertia = 0.;
  for (unsigned int i = 0; i < n; ++i)
  {
    forces[i] -= resultant / n;
    moment += cross(middles[i], forces[i]);
    inertia += (middles[i] - mean_middle).norm_square();
  }
  for (unsigned int i = 0; i < n; ++i)
  {
    const Tensor<1, 2> arm = middles[i] - mean_middle;
    forces[i] += (torque - moment) / inertia * Tensor<1, 2>({-arm[1], arm[0]});
  }
  return forces;
}

std::vector<SubCellStress> solve(CellStress &cell_stress,
                                 const std::vector<Point<2>> &vertices,
                                 const std::vector<Tensor<1, 2>> &forces)
{
  std::vector<SubCellStress> sub_cells(cell_stress.n_sub_cells());
  check("a unique answer",
        cell_stress.solve(
            {{}, vertices, forces, std::vector<Tensor<1, 2>>(vertices.size())},
            {sub_cells.data(), sub_cells.size()}));
  return sub_cells;
}

double largest_divergence(const std::vector<SubCellStress> &sub_cells)
{
  double largest = 0.;
  for (const auto &sub_cell : sub_cells)
    largest = std::max(largest, sub_cell.divergence.norm());
  return largest;
}

double largest_skew(const std::vector<SubCellStress> &sub_cells)
{
  double largest = 0.;
  for (const auto &sub_cell : sub_cells)
    largest = std::max(largest, sub_cell.skew);
  return largest;
}

void run()
{
  boost::random::mt19937 random(1);
  for (const unsigned int n : {3U, 4U, 6U, 11U})
    for (const unsigned int degree : {0U, 1U})
    {
      std::cout << n << " sides, degree " << degree << std::endl;
      const std::vector<Point<2>> vertices = polygon(n, random);
      const auto forces = balanced_forces(vertices, 0., random);
      LeastNorm coarse(n, 0, degree), middle(n, 1, degree), fine(n, 2, degree);
      const auto on_coarse = solve(coarse, vertices, forces);
      const auto on_middle = solve(middle, vertices, forces);
      const auto on_fine = solve(fine, vertices, forces);
      check_error("  no torque: div sigma",
                  std::max({largest_divergence(on_coarse),
                            largest_divergence(on_middle),
                            largest_divergence(on_fine)}),
                  1e-11);
      check("  skew part falls by refinement or is rounding",
            largest_skew(on_fine) < 0.9 * largest_skew(on_coarse) ||
                largest_skew(on_coarse) < 1e-11);
      if (n > 4)
      {
        Fan fan(n);
        check("  the fan leaves some divergence",
              largest_divergence(solve(fan, vertices, forces)) > 1e-3);
      }

      // The torque of div sigma is that of the tractions. Only with degree 0
      // the mean over a sub-cell says all of it.
      const auto turning = balanced_forces(vertices, 1., random);
      const auto turned = solve(fine, vertices, turning);
      const SubTriangulation cut = SubTriangulation::thirds(2);
      const unsigned int per_side = cut.of_triangle().size();
      double torque = 0.;
      Tensor<1, 2> resultant;
      for (unsigned int s = 0; s < turned.size(); ++s)
      {
        const auto q = cut.corners(s % per_side, {}, vertices[s / per_side],
                                   vertices[(s / per_side + 1) % n]);
        const double area = 0.5 * cross(q[3] - q[0], q[2] - q[1]);
        const Tensor<1, 2> arm =
            0.25 * (q[0] + q[1] + q[2] + q[3] - Point<2>());
        torque += area * cross(arm, turned[s].divergence);
        resultant += area * turned[s].divergence;
      }
      if (degree == 0)
        check_error("  torque of div sigma", std::abs(torque - 1.), 1e-11);
      check_error("  resultant of div sigma", resultant.norm(), 1e-11);
    }
}

const RoomTest test("least_norm", run);
} // namespace test_least_norm
