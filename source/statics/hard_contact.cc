// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/newton.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/statics/hard_contact.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
/**
 * The largest change of a force in the last step, nondimensional: convergence
 * is quadratic, so that the error is near its square.
 */
constexpr double largest_force_change = 1e-8;
/** An imbalance, nondimensional, that is rounding. */
constexpr double rounding = 1e-15;
/** The ratio of the imbalances of two steps below which another follows. */
constexpr double worthwhile = 0.5;
/** The largest number of steps; from Ipopt's point a handful suffices. */
constexpr unsigned int n_max_steps = 20;

/** True if @p newton converges to the minimum. */
bool converges(Newton &newton, const double tolerance)
{
  if (!std::isfinite(newton.imbalance()))
    return false;
  for (unsigned int k = 0; k < n_max_steps; ++k)
  {
    newton.full_step();
    const double change = newton.force_change();
    if (change <= largest_force_change && newton.imbalance() <= tolerance)
      return true;
  }
  return false;
}

/** Go on from the minimum as long as the forces come to balance better. */
std::vector<double> most_balanced(Newton &newton)
{
  std::vector<double> forces = newton.forces();
  double least = newton.imbalance();
  for (unsigned int k = 0; k < n_max_steps && least > rounding; ++k)
  {
    newton.full_step();
    const double before = least;
    if (newton.imbalance() < least)
    {
      least = newton.imbalance();
      forces = newton.forces();
    }
    if (!(newton.imbalance() < worthwhile * before))
      break;
  }
  return forces;
}
} // namespace

void HardJoint::find_forces(const unsigned int e,
                            const double *jumps,
                            double *forces) const
{
  friction.find_forces(e, jumps, forces);
  for (unsigned int r = 0; r < friction.n_contacts(); ++r)
    forces[r] = jumps[r] > 0. ? -mu / jumps[r]
                              : -std::numeric_limits<double>::infinity();
}

void HardJoint::find_second_derivatives(const unsigned int e,
                                        const double *jumps,
                                        double *second) const
{
  friction.find_second_derivatives(e, jumps, second);
  for (unsigned int r = 0; r < friction.n_contacts(); ++r)
    second[r] = mu / jumps[r] / jumps[r];
}

double HardJoint::longest_step(const unsigned int /*e*/,
                               const double *jumps,
                               const double *steps) const
{
  double longest = std::numeric_limits<double>::infinity();
  for (unsigned int r = 0; r < friction.n_contacts(); ++r)
    if (steps[r] < 0.)
      longest = std::min(longest, -jumps[r] / steps[r]);
  return longest;
}

void refine_hard_contact(const DiscreteProblem &problem,
                         const HardJoint &law,
                         std::vector<double> &u,
                         const double tolerance,
                         Solution &solution)
{
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    if (!(problem.opening(e, u.data()) > 0.))
      return; // by rounding; the energy has no value there
  JointSystem system(problem, LinearSolver::automatic);
  Newton newton(problem, law, system, u);
  std::vector<double> forces;
  try
  {
    if (!converges(newton, tolerance))
      return;
    forces = most_balanced(newton);
  }
  catch (const SolverError &)
  {
    return; // Ipopt's forces stand
  }
  solution.forces = std::move(forces);
  solution.n_iterations += newton.n_iterations();
  solution.n_evaluations += newton.n_evaluations();
  u = newton.u();
  solution.stop = Stop::Reason::converged;
}
} // namespace Voussoir
