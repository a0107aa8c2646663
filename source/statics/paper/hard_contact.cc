// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/newton.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/statics/paper/hard_contact.h>

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
constexpr double rounding_of_imbalance = 1e-15;
/** The ratio of the imbalances of two steps below which another follows. */
constexpr double worthwhile_force_step = 0.5;
/** The largest number of steps; from Ipopt's point a handful suffices. */
constexpr unsigned int n_max_steps = 20;

/**
 * The energy of one joint with smoothed friction and hard contact at a given
 * point of the central path,
 *
 *     s_e |e| h(x) - sum mu log y,
 *
 * with x, y and h as in SmoothedJoint. The force of a contact is -mu / y. All
 * nondimensional.
 */
class HardJoint : public JointLaw
{
public:
  HardJoint(const SmoothedJoint &friction, const double mu)
      : friction(friction), mu(mu)
  {}

  void find_forces(const unsigned int e,
                   const double *jumps,
                   double *forces) const override
  {
    friction.find_forces(e, jumps, forces);
    for (unsigned int r = 0; r < friction.n_contacts(e); ++r)
      forces[r] = jumps[r] > 0. ? -mu / jumps[r]
                                : -std::numeric_limits<double>::infinity();
  }
  bool find_second_derivatives(const unsigned int e,
                               const double *jumps,
                               double *second) const override
  {
    friction.find_second_derivatives(e, jumps, second);
    for (unsigned int r = 0; r < friction.n_contacts(e); ++r)
      second[r] = mu / jumps[r] / jumps[r];
    return is_isotropic(second, friction.n_contacts(e));
  }
  double longest_step(const unsigned int e,
                      const double *jumps,
                      const double *steps) const override
  {
    double longest = std::numeric_limits<double>::infinity();
    for (unsigned int r = 0; r < friction.n_contacts(e); ++r)
      if (steps[r] < 0.)
        longest = std::min(longest, -jumps[r] / steps[r]);
    return longest;
  }

private:
  const SmoothedJoint &friction;
  const double mu;
};

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
  for (unsigned int k = 0; k < n_max_steps && least > rounding_of_imbalance;
       ++k)
  {
    newton.full_step();
    const double before = least;
    if (newton.imbalance() < least)
    {
      least = newton.imbalance();
      forces = newton.forces();
    }
    if (!(newton.imbalance() < worthwhile_force_step * before))
      break;
  }
  return forces;
}
} // namespace

void refine_hard_contact(const DiscreteProblem &problem,
                         const SmoothedJoint &friction,
                         const double mu,
                         std::vector<double> &u,
                         const double tolerance,
                         Solution &solution)
{
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    if (!(problem.opening(e, u.data()) > 0.))
      return; // by rounding; the energy has no value there
  const HardJoint law(friction, mu);
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
