// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/newton.h>
#include <voussoir/statics/opening.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
using dealii::Tensor;
using Joint = DiscreteProblem::Joint;
using Jump = DiscreteProblem::Jump;

/**
 * The cosine of the angle between a support and the way that the ground is
 * drawn back, below which it would have to go too far.
 */
constexpr double least_cosine = 1e-2;

/** The proximal term of a step; joints that are open leave cells free. */
constexpr double shift = 1e-6;
/** By how much of d_e a joint must open to count as open. */
constexpr double least_opening = 0.5;
/** The forces, relative to stiffnesses and distances of order one, that end
 * the search: they cannot be relieved. */
constexpr double smallest_imbalance = 1e-9;
constexpr unsigned int n_max_iterations = 200;

/** A spring that pushes until its joint has opened by d_e. */
class PushingJoint : public JointLaw
{
public:
  explicit PushingJoint(const DiscreteProblem &problem) : problem(problem)
  {
  }

  Jump force(const unsigned int e, const Jump &jump) const override
  {
    const Joint &joint = problem.joints()[e];
    return {joint.stiffness() * std::min(jump.normal - joint.distance, 0.), 0.};
  }

  Jump second_derivative(const unsigned int e, const Jump &jump) const override
  {
    const Joint &joint = problem.joints()[e];
    return {jump.normal < joint.distance ? joint.stiffness() : 0., 0.};
  }

private:
  const DiscreteProblem &problem;
};

/**
 * Where the ground has to be for its supports to open by d_e in the dilation u
 * = x_c: beyond the line of each of them.
 *
 * @return whether there is such a point.
 */
bool draw_back_ground(const DiscreteProblem &problem, Tensor<1, 2> &ground)
{
  Tensor<1, 2> mean_normal, mean_point;
  double length = 0.;
  const auto for_supports = [&](const auto &visit) {
    for (const Joint &joint : problem.joints())
      if (joint.cell_plus == problem.n_cells())
        visit(joint, problem.centres()[joint.cell_minus] +
                         joint.distance * joint.normal);
  };
  for_supports([&](const Joint &joint, const Tensor<1, 2> &point) {
    mean_normal += joint.length * joint.normal;
    mean_point += joint.length * point;
    length += joint.length;
  });
  ground = mean_point / length;
  if (!(mean_normal.norm() > least_cosine * length))
    return false;

  const Tensor<1, 2> back = mean_normal / mean_normal.norm();
  double distance = 0.;
  bool all_face_back = true;
  for_supports([&](const Joint &joint, const Tensor<1, 2> &point) {
    const double cosine = joint.normal * back;
    if (cosine > least_cosine)
      distance = std::max(distance, (point - ground) * joint.normal / cosine);
    else
      all_face_back = false;
  });
  ground += distance * back;
  return all_face_back;
}
} // namespace

std::vector<double> find_opening(const DiscreteProblem &problem)
{
  std::vector<double> u(problem.n_dofs());
  for (unsigned int c = 0; c < problem.n_cells(); ++c)
    for (unsigned int i = 0; i < 2; ++i)
      u[problem.dof(c, i)] = problem.centres()[c][i];
  if (problem.n_bodies() == problem.n_cells())
    return u;
  Tensor<1, 2> ground;
  if (draw_back_ground(problem, ground))
  {
    for (unsigned int i = 0; i < 2; ++i)
      u[problem.dof(problem.n_cells(), i)] = ground[i];
    return u;
  }

  const DiscreteProblem unloaded = problem.without_loads();
  const PushingJoint law(unloaded);
  JointSystem system(unloaded, LinearSolver::automatic);
  Newton newton(unloaded, law, system, u);
  while (newton.n_iterations() < n_max_iterations)
  {
    newton.step(shift, newton.u());
    bool all_open = true;
    for (unsigned int e = 0; e < problem.joints().size(); ++e)
      all_open &= newton.jumps()[e].normal >
                  least_opening * problem.joints()[e].distance;
    if (all_open)
      return newton.u();
    if (newton.imbalance() <= smallest_imbalance)
      break;
  }
  return {};
}
} // namespace Voussoir
