// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/smoothed_joint.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
using Joint = DiscreteProblem::Joint;

SmoothedJoint::SmoothedJoint(const DiscreteProblem &problem,
                             const Contact contact)
    : problem(problem), contact(contact)
{
  // For hard contact any common smoothing length gives the same forces. The
  // larger of one and the strongest stress keeps displacements of order one.
  for (const Joint &joint : problem.joints())
    common_smoothing =
        std::max(common_smoothing, joint.strength / joint.length);
}

double SmoothedJoint::smoothing(const Joint &joint) const
{
  if (contact == Contact::hard)
    return joint.strength > 0. ? common_smoothing : 0.;
  return joint.strength / joint.length * joint.distance;
}

double SmoothedJoint::displacement_unit() const
{
  return contact == Contact::hard ? common_smoothing : 1.;
}

double SmoothedJoint::energy(const unsigned int e, const Jump &jump) const
{
  const Joint &joint = problem.joints()[e];
  double energy = 0.;
  const double eps = smoothing(joint), x = jump.tangential;
  if (eps > 0.) // sqrt(x^2 + eps^2) - eps without its cancellation
    energy += joint.strength * x * (x / (std::hypot(x, eps) + eps));
  if (contact == Contact::compliant && jump.normal < 0.)
    energy += 0.5 * joint.stiffness() * jump.normal * jump.normal;
  return energy;
}

JointLaw::Jump SmoothedJoint::force(const unsigned int e,
                                    const Jump &jump) const
{
  const Joint &joint = problem.joints()[e];
  Jump force = {0., 0.};
  const double eps = smoothing(joint), x = jump.tangential;
  if (eps > 0.)
    force.tangential = joint.strength * (x / std::hypot(x, eps));
  if (contact == Contact::compliant)
    force.normal = joint.stiffness() * std::min(jump.normal, 0.);
  return force;
}

JointLaw::Jump SmoothedJoint::second_derivative(const unsigned int e,
                                                const Jump &jump) const
{
  const Joint &joint = problem.joints()[e];
  Jump second = {0., 0.};
  const double eps = smoothing(joint);
  if (eps > 0.)
  {
    const double r = std::hypot(jump.tangential, eps);
    second.tangential = joint.strength / r * (eps / r) * (eps / r);
  }
  if (contact == Contact::compliant && jump.normal <= 0.)
    second.normal = joint.stiffness();
  return second;
}
} // namespace Voussoir
