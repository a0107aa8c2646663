// SPDX-License-Identifier: LGPL-2.1-or-later

// The linear systems of Newton's method: whatever method takes one, the
// residual that is left is the one that was asked for, computed from the
// joints.

#include <voussoir/algebra/joint_law.h>
#include <voussoir/algebra/linear/joint_system.h>
#include <voussoir/algebra/linear/near_componentwise.h>
#include <voussoir/statics/problem/discrete_problem.h>

#include "tests.h"
#include <random>

namespace test_linear_systems
{
using namespace Voussoir;

/** Of any right-hand side, with the least shift; relative, by the norm. */
double residual(const DiscreteProblem &problem,
                JointSystem &system,
                const std::vector<double> &coefficients,
                const double shift)
{
  std::vector<double> r(problem.n_dofs());
  std::mt19937 random(1);
  for (double &component : r)
    component = random() / double(std::mt19937::max()) - 0.5;
  problem.remove_rigid_motions(r);
  bool are_isotropic = true;
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    are_isotropic &= is_isotropic(&coefficients[problem.first_row(e)], 1);
  system.prepare({coefficients, are_isotropic}, shift);
  const std::vector<double> u = system.solve(r);
  std::vector<double> f = problem.jumps(u), left = r;
  for (std::size_t k = 0; k < f.size(); ++k)
    f[k] *= coefficients[k];
  problem.add_jump_gradients(-1., f, left);
  double of_right = 0., of_left = 0.;
  for (std::size_t k = 0; k < r.size(); ++k)
  {
    of_right += r[k] * r[k];
    of_left += (left[k] - shift * u[k]) * (left[k] - shift * u[k]);
  }
  return std::sqrt(of_left / of_right);
}

/** The tangential coefficients are parts of the normal ones, from @p least. */
std::vector<double> coefficients(const DiscreteProblem &problem,
                                 const double least)
{
  std::vector<double> a;
  std::mt19937 random(2);
  for (const DiscreteProblem::Joint &joint : problem.joints())
  {
    const double part = random() / double(std::mt19937::max());
    a.push_back(joint.stiffness());
    a.push_back((least + (1. - least) * part) * joint.stiffness());
  }
  return a;
}

void run()
{
  const Scene scene =
      scene_under_stress(random_packing(500, 1), 1., tensor(-1., 0., 0., -1.));
  const DiscreteProblem problem = discretise(scene);
  for (const double least : {1., 0.5, 0.15, 1e-3})
  {
    std::cout << "tangential coefficients from " << least << std::endl;
    const std::vector<double> a = coefficients(problem, least);
    check("  close to those of one component",
          NearComponentwise::serves(problem, a) == (least > 0.125));
    for (const double shift : {1e-6, least_shift})
    {
      JointSystem exact(problem, LinearSolver::direct);
      check_error("  exact", residual(problem, exact, a, shift), 1e-8);
      for (const double allowed : {1e-2, 1e-6})
      {
        JointSystem inexact(problem, LinearSolver::direct, allowed);
        check_error("  inexact", residual(problem, inexact, a, shift), allowed);
        check("  then again", residual(problem, inexact, a, shift) <= allowed);
      }
    }
  }
}

const RoomTest test("linear_systems", run);
} // namespace test_linear_systems
