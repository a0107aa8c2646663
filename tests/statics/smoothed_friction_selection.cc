// SPDX-License-Identifier: LGPL-2.1-or-later

// What smoothed friction selects in homogeneous compression of random cells.
// Compliant contact: the tractions of sigma = -I. Hard contact: no tangential
// force, and the normal forces that maximise sum_e log p_e among all that
// balance, computed here by Newton's method on the dual of that problem.

#include <deal.II/lac/lapack_full_matrix.h>

#include "tests.h"

namespace test_smoothed_friction_selection
{
using namespace Voussoir;

/**
 * The analytic centre of { p > 0 : sum of the forces of p and F = 0 on every
 * cell }, from a balanced p: steps dp = p - p^2 A^T y with A dp = 0.
 */
std::vector<double> analytic_centre(const Scene &scene, std::vector<double> p)
{
  const auto &interfaces = scene.packing.interfaces();
  const unsigned int n = 2 * (scene.packing.n_cells() - 1); // without cell 0
  const auto for_entries = [&](const unsigned int e, const auto &visit) {
    for (unsigned int i = 0; i < 2; ++i)
      for (const bool plus : {false, true})
      {
        const unsigned int c =
            plus ? interfaces[e].cell_plus : interfaces[e].cell_minus;
        if (c > 0)
          visit(2 * (c - 1) + i,
                plus ? interfaces[e].normal[i] : -interfaces[e].normal[i]);
      }
  };
  for (unsigned int step = 0; step < 100; ++step)
  {
    dealii::LAPACKFullMatrix<double> matrix(n);
    dealii::Vector<double> y(n);
    for (unsigned int e = 0; e < p.size(); ++e)
      for_entries(e, [&](const unsigned int row, const double a) {
        y[row] += a * p[e];
        for_entries(e, [&](const unsigned int column, const double b) {
          matrix(row, column) += a * b * p[e] * p[e];
        });
      });
    matrix.compute_lu_factorization();
    matrix.solve(y);

    std::vector<double> relative(p.size(), 1.); // dp / p
    double largest = 0.;
    for (unsigned int e = 0; e < p.size(); ++e)
    {
      for_entries(e, [&](const unsigned int row, const double a) {
        relative[e] -= p[e] * a * y[row];
      });
      largest = std::max(largest, std::abs(relative[e]));
    }
    for (unsigned int e = 0; e < p.size(); ++e)
      p[e] += p[e] * relative[e] / (1. + (largest > 0.5 ? largest : 0.));
    if (largest < 1e-10)
      return p;
  }
  return {};
}

void run()
{
  const Scene scene =
      scene_under_stress(random_packing(60, 4), 10, tensor(-1, 0, 0, -1));
  const auto &interfaces = scene.packing.interfaces();

  const InterfaceForces soft = Solver(compliant).forces(scene);
  double normal = 0., tangential = 0.;
  for (unsigned int e = 0; e < interfaces.size(); ++e)
  {
    normal =
        std::max(normal, std::abs(soft.normal[e] / interfaces[e].length + 1));
    tangential = std::max(tangential,
                          std::abs(soft.tangential[e]) / interfaces[e].length);
  }
  check_error("compliant: normal stress + 1", normal, 1e-9);
  check_error("compliant: tangential stress", tangential, 1e-9);

  const InterfaceForces rigid = Solver(hard).forces(scene);
  std::vector<double> p;
  for (const double f : rigid.normal)
    p.push_back(-f);
  const std::vector<double> centre = analytic_centre(scene, p);
  check("hard: the analytic centre exists", centre.size() == p.size());
  double error = 0.;
  tangential = 0.;
  for (unsigned int e = 0; e < centre.size(); ++e)
  {
    error = std::max(error, std::abs(p[e] - centre[e]));
    tangential = std::max(tangential, std::abs(rigid.tangential[e]));
  }
  check_error("hard: distance from it", error, 1e-8);
  check_error("hard: tangential force", tangential, 1e-6);
  check_error("hard: equilibrium", certify(scene, rigid).equilibrium_residual,
              1e-9);
}

const RoomTest test("smoothed_friction_selection", run);
} // namespace test_smoothed_friction_selection
