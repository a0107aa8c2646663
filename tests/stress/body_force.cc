// SPDX-License-Identifier: LGPL-2.1-or-later

// Stress under a body force. Where the forces on a triangle or quadrilateral
// leave no torque, div sigma = -b in the mean over each sub-cell, for any b; in
// cells with more sides, over the cell. The mean stress of the cells is that of
// the exact field; the torque of the body force counts.

#include <voussoir/scene/supports.h>
#include <voussoir/stress/cell_means.h>
#include <voussoir/stress/reconstruction.h>

#include <deal.II/base/quadrature_lib.h>

#include "tests.h"

namespace test_body_force
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** A regular polygon around the origin with its first side at the bottom. */
Packing<2> polygon(const unsigned int n)
{
  CellLoops cells;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double angle = dealii::numbers::PI * ((2. * i - 1.) / n - 0.5);
    cells.vertices.emplace_back(std::cos(angle), std::sin(angle));
    cells.loops.push_back(i);
  }
  cells.first.push_back(n);
  return Packing<2>(cells);
}

/** What stress and body force leave of div sigma = -b, over all sub-cells. */
double error_of_divergence(const Scene &scene, const StressField &field)
{
  double error = 0.;
  for (unsigned int c = 0; c < scene.packing.n_cells(); ++c)
    for (unsigned int i = 0; i < scene.packing.n_sides(c); ++i)
    {
      const Tensor<1, 2> a =
          scene.packing.vertex(c, i) - scene.packing.centre(c);
      const Tensor<1, 2> b =
          scene.packing.vertex(c, i + 1) - scene.packing.centre(c);
      const Tensor<1, 2> mean_force = scene.body.force(scene.packing, c, i) /
                                      (0.5 * (a[0] * b[1] - a[1] * b[0]));
      const auto &sub_cell = field.sub_cells[scene.packing.first_side(c) + i];
      error =
          std::max({error, (sub_cell.divergence + mean_force).norm(),
                    std::abs(sub_cell.stress[0][1] - sub_cell.stress[1][0])});
    }
  return error;
}

void run()
{
  std::ostringstream nowhere;
  Terminal &quiet = Terminal::silent();

  // Regular polygons in a fluid whose pressure and density vary with depth, so
  // that all is symmetric: sigma = -p(y) I, b = (0, p').
  for (const unsigned int n : {3U, 4U, 5U, 8U, 11U})
  {
    const auto p = [](const double y) { return 3. - y + 0.2 * y * y * y; };
    Packing<2> packing = polygon(n);
    Loads loads;
    const dealii::QGauss<1> gauss(4);
    for (const auto &edge : packing.boundary_edges())
    {
      double mean = 0.;
      for (unsigned int q = 0; q < gauss.size(); ++q)
        mean +=
            gauss.weight(q) *
            p((edge.start + gauss.point(q)[0] * (edge.end - edge.start))[1]);
      loads.traction.push_back(-mean * edge.normal);
    }
    loads.body = BodyForce(packing, [](const Point<2> &x, unsigned int) {
      return Tensor<1, 2>({0., -1. + 0.6 * x[1] * x[1]});
    });
    const Scene scene(std::move(packing), {}, std::move(loads));
    const StressField field = reconstruct_stress(scene, {}, {}, quiet);
    // With more sides the fluxes through the spokes are too few for both.
    if (n <= 4)
      check_error(std::to_string(n) + " sides: div sigma + b and skew part",
                  error_of_divergence(scene, field), 1e-13);
    Tensor<1, 2> resultant = scene.body.force(scene.packing, 0);
    for (const auto &sub_cell : field.sub_cells)
      resultant += scene.packing.area(0) / n * sub_cell.divergence;
    check_error(std::to_string(n) + " sides: resultant of div sigma + b",
                resultant.norm(), 1e-13);
  }

  // A stack of bricks on the ground: sigma_yy = -gamma (H - y), so the mean of
  // a brick is that at its middle.
  Packing<2> bricks = wall(1, 1, 0.5, 2.);
  bricks.support(boundary_edges_where(bricks, "y < 0.01", "Supports/Where"));
  Loads weight;
  weight.traction.resize(bricks.boundary_edges().size());
  weight.body = BodyForce(bricks, [](const Point<2> &, unsigned int) {
    return Tensor<1, 2>({0., -20.});
  });
  const Scene brick(std::move(bricks), {1.}, std::move(weight));
  const InterfaceForces reaction = Solver(least_energy).forces(brick);
  const Tensor<2, 2> mean = cell_mean_stresses(brick, reaction)[0];
  check_error("brick: mean stress", (mean - tensor(0., 0., 0., -20.)).norm(),
              1e-13);
  check_error("brick: div sigma + b and skew part",
              error_of_divergence(
                  brick, reconstruct_stress(brick, reaction, {}, quiet)),
              1e-12);

  // The centre of a Voronoi cell is not its centroid: a uniform body force and
  // the tractions that balance it leave the torque of the lever between them.
  Packing<2> cells = random_packing(40, 3);
  const Tensor<1, 2> b({0.3, -1.});
  Loads loads;
  loads.traction.resize(cells.boundary_edges().size());
  loads.body =
      BodyForce(cells, [&](const Point<2> &, unsigned int) { return b; });
  cells.support(std::vector<bool>(cells.boundary_edges().size(), true));
  loads.traction.clear();
  const std::vector<double> strengths(cells.interfaces().size(), 10.);
  const Scene grains(std::move(cells), strengths, std::move(loads));
  const InterfaceForces forces = Solver(least_energy).forces(grains);
  const std::vector<double> torques = residual_torques(grains, forces);
  const auto means = cell_mean_stresses(grains, forces);
  double error = 0.;
  for (unsigned int c = 0; c < torques.size(); ++c)
    error = std::max(error, std::abs((means[c][1][0] - means[c][0][1]) *
                                         grains.packing.area(c) -
                                     torques[c]));
  check_error("torque is the skew part of the mean stress", error, 1e-14);
  check_error("grains held all around: residual",
              certify(grains, forces).equilibrium_residual, 1e-9);
}

const RoomTest test("body_force", run);
} // namespace test_body_force
