// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/problem/opening_proofs.h>

#include <cmath>

namespace Voussoir
{
namespace
{
using dealii::Tensor;

/** The error of a vertex, in roundings of a coordinate. */
constexpr double n_roundings = 32.;

/**
 * The error of n_e from the rounding of the coordinates. In space the width of
 * a joint is at least its area where it is no longer than a cell.
 */
double error_of_normal(const DiscreteProblem &problem,
                       const DiscreteProblem::Joint &joint)
{
  return n_roundings * problem.rounding_of_coordinates() *
         (1. + 1. / joint.length);
}

/** The size of what @p u moves a joint in space by, at row @p k among all; of
 * what turns, at most that. */
double size_of_motion(const DiscreteProblem &problem,
                      const DiscreteProblem::Joint &joint,
                      const std::size_t k,
                      const std::vector<double> &u)
{
  const double *minus = &u[problem.dof(joint.cell_minus, 0)];
  const double *plus = &u[problem.dof(joint.cell_plus, 0)];
  double size =
      std::hypot(plus[0] - minus[0], plus[1] - minus[1], plus[2] - minus[2]);
  if (!problem.kinematics().turns())
    return size;
  // The arm of a row has what is seen in its turn, and d_e along the normal.
  const auto add_turn = [&](const double *of_body, const double *turn) {
    size += std::hypot(of_body[3], of_body[4], of_body[5]) *
            (std::hypot(turn[0], turn[1], turn[2]) + joint.distance);
  };
  add_turn(minus, problem.turn_minus(k));
  add_turn(plus, problem.turn_plus(k));
  return size;
}
} // namespace

bool opens_all_joints(const DiscreteProblem &problem,
                      const std::vector<double> &u)
{
  bool all_open = true;
  for (unsigned int e = 0; e < problem.joints().size() && all_open; ++e)
  {
    const DiscreteProblem::Joint &joint = problem.joints()[e];
    const double error = error_of_normal(problem, joint);
    problem.for_each_pressure(e, [&](const unsigned int r, double) {
      const double opening = problem.jump(e, r, u.data());
      const double size =
          problem.is_plane()
              ? std::hypot(opening, problem.sliding(e, u.data()))
              : size_of_motion(problem, joint, problem.first_row(e) + r, u);
      all_open &= opening > error * size;
    });
  }
  return all_open;
}

bool is_self_stress(const DiscreteProblem &problem,
                    const std::vector<double> &p)
{
  if (p.empty())
    return false;
  double rounding = 0.;
  bool press = true;
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    problem.for_each_pressure(e, [&](const unsigned int r, double) {
      const double pressure = p[problem.first_row(e) + r];
      press &= pressure >= 0.;
      rounding += pressure * error_of_normal(problem, problem.joints()[e]);
    });
  if (!press)
    return false;
  std::vector<double> sum(problem.n_dofs());
  problem.add_jump_gradients(1., p, sum);
  double left = 0.;
  for (unsigned int b = 0; b < problem.n_bodies(); ++b)
  {
    const double *of_body = &sum[problem.dof(b, 0)];
    left += problem.is_plane() ? std::hypot(of_body[0], of_body[1])
                               : std::hypot(of_body[0], of_body[1], of_body[2]);
    // The ground does not turn, and is far from some of its joints.
    for (unsigned int i = problem.n_translations();
         i < problem.n_unknowns() && b < problem.n_cells(); ++i)
      left += std::abs(of_body[i]);
  }
  return rounding > 0. && left <= rounding;
}
} // namespace Voussoir
