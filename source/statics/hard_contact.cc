// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/newton.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/statics/hard_contact.h>

#include <cmath>
#include <limits>

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
std::vector<JointLaw::Jump> most_balanced(Newton &newton)
{
  std::vector<JointLaw::Jump> forces = newton.forces();
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

HardJoint::HardJoint(const SmoothedJoint &friction, const double mu)
    : friction(friction), mu(mu)
{
}

JointLaw::Jump HardJoint::force(const unsigned int e, const Jump &jump) const
{
  Jump force = friction.force(e, jump);
  force.normal = jump.normal > 0. ? -mu / jump.normal
                                  : -std::numeric_limits<double>::infinity();
  return force;
}

JointLaw::Jump HardJoint::second_derivative(const unsigned int e,
                                            const Jump &jump) const
{
  Jump second = friction.second_derivative(e, jump);
  second.normal = mu / jump.normal / jump.normal;
  return second;
}

double HardJoint::longest_step(const unsigned int /*e*/,
                               const Jump &jump,
                               const Jump &step) const
{
  return step.normal >= 0. ? std::numeric_limits<double>::infinity()
                           : -jump.normal / step.normal;
}

void refine_hard_contact(const DiscreteProblem &problem,
                         const HardJoint &law,
                         std::vector<double> &u,
                         const double tolerance,
                         Solution &solution)
{
  for (const DiscreteProblem::Joint &joint : problem.joints())
    if (!(problem.jump(joint, u.data()).normal > 0.))
      return; // by rounding; the energy has no value there
  JointSystem system(problem, LinearSolver::automatic);
  Newton newton(problem, law, system, u);
  std::vector<JointLaw::Jump> forces;
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
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    solution.forces.normal[e] = forces[e].normal;
    solution.forces.tangential[e] = forces[e].tangential;
  }
  solution.n_iterations += newton.n_iterations();
  solution.n_evaluations += newton.n_evaluations();
  u = newton.u();
  solution.stop = Stop::Reason::converged;
}
} // namespace Voussoir
