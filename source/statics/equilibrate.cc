// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/joint_system.h>
#include <voussoir/statics/equilibrate.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace Voussoir
{
using Joint = DiscreteProblem::Joint;
using Jump = DiscreteProblem::Jump;

namespace
{
/** An error, nondimensional, that is rounding. */
constexpr double rounding = 1e-15;
/** The ratio of the errors of two rounds below which another follows. */
constexpr double worthwhile = 0.5;
constexpr unsigned int n_max_rounds = 30;
/** The refinements of a correction, for the shift and the rounding in it. */
constexpr unsigned int n_refinements = 2;

/** The distance from its limit, as a stress, at which a force moves freely. */
constexpr double ample_slack = 0.1;

/** The largest shift whose error in the balance the refinements remove. */
constexpr double largest_shift = 1.;

/** The sum of all forces on each body, n_dofs() numbers. */
std::vector<double> imbalance(const DiscreteProblem &problem,
                              const InterfaceForces &forces)
{
  std::vector<double> sum(problem.n_dofs());
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    problem.add_jump_gradient(problem.joints()[e],
                              {-forces.normal[e], -forces.tangential[e]},
                              sum.data());
  for (unsigned int b = 0; b < problem.n_bodies(); ++b)
    for (unsigned int i = 0; i < 2; ++i)
      sum[problem.dof(b, i)] += problem.loads()[b][i];
  return sum;
}

/** The largest force that is missing to a balance, or beyond its limit. */
double error(const DiscreteProblem &problem, const InterfaceForces &forces)
{
  double largest = 0.;
  for (const double component : imbalance(problem, forces))
    largest = std::max(largest, std::abs(component));
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    largest = std::max(
        {largest, forces.normal[e],
         std::abs(forces.tangential[e]) - problem.joints()[e].strength});
  return largest;
}

void move_into_limits(const DiscreteProblem &problem, InterfaceForces &forces)
{
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const double strength = problem.joints()[e].strength;
    forces.normal[e] = std::min(forces.normal[e], 0.);
    forces.tangential[e] =
        std::clamp(forces.tangential[e], -strength, strength);
  }
}

/** (|e|/d_e) w_e, which turns a jump into a force. */
std::vector<Jump> weighted_stiffnesses(const DiscreteProblem &problem,
                                       const InterfaceForces &forces)
{
  std::vector<Jump> stiffness(problem.joints().size());
  for (unsigned int e = 0; e < stiffness.size(); ++e)
  {
    const Joint &joint = problem.joints()[e];
    const auto weight = [&](const double slack) {
      return joint.stiffness() *
             std::min(1., slack / (ample_slack * joint.length));
    };
    stiffness[e] = {weight(-forces.normal[e]),
                    weight(joint.strength - std::abs(forces.tangential[e]))};
  }
  return stiffness;
}

/** Add the smallest correction that balances; false if rounding prevents it. */
bool correct(const DiscreteProblem &problem,
             JointSystem &system,
             InterfaceForces &forces)
{
  const std::vector<Jump> stiffness = weighted_stiffnesses(problem, forces);
  double shift = least_shift;
  while (!system.prepare(stiffness, shift))
    if ((shift *= factor_of_shift) > largest_shift)
      return false;
  for (unsigned int k = 0; k <= n_refinements; ++k)
  {
    // Bodies move the way that they are pushed, and joints push back.
    const std::vector<double> u = system.solve(imbalance(problem, forces));
    for (unsigned int e = 0; e < stiffness.size(); ++e)
    {
      const Jump jump = problem.jump(problem.joints()[e], u.data());
      forces.normal[e] += stiffness[e].normal * jump.normal;
      forces.tangential[e] += stiffness[e].tangential * jump.tangential;
    }
  }
  return true;
}
} // namespace

InterfaceForces equilibrate(const DiscreteProblem &problem,
                            const InterfaceForces &forces)
{
  InterfaceForces best = forces;
  double least = error(problem, best);
  if (problem.joints().empty() || !(least > rounding))
    return best;

  JointSystem system(problem, LinearSolver::automatic);
  InterfaceForces trial = forces;
  double before = std::numeric_limits<double>::infinity();
  for (unsigned int k = 0; k < n_max_rounds && least > rounding; ++k)
  {
    move_into_limits(problem, trial);
    if (!correct(problem, system, trial))
      break;
    const double now = error(problem, trial);
    if (now < least)
    {
      best = trial;
      least = now;
    }
    if (!(now < worthwhile * before))
      break;
    before = now;
  }
  return best;
}
} // namespace Voussoir
