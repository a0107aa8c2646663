// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/smoothed_joint.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/** k_e */
double stiffness(const DiscreteProblem::Joint &joint)
{
  return joint.length / joint.distance;
}
} // namespace

SmoothedJoint::SmoothedJoint(const DiscreteProblem &problem,
                             const Contact contact)
    : contact(contact)
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

double SmoothedJoint::energy(const Joint &joint, const Jump &jump) const
{
  double energy = 0.;
  const double eps = smoothing(joint), x = jump.tangential;
  if (eps > 0.) // sqrt(x^2 + eps^2) - eps without its cancellation
    energy += joint.strength * x * (x / (std::hypot(x, eps) + eps));
  if (contact == Contact::compliant && jump.normal < 0.)
    energy += 0.5 * stiffness(joint) * jump.normal * jump.normal;
  return energy;
}

SmoothedJoint::Jump SmoothedJoint::force(const Joint &joint,
                                         const Jump &jump) const
{
  Jump force = {0., 0.};
  const double eps = smoothing(joint), x = jump.tangential;
  if (eps > 0.)
    force.tangential = joint.strength * (x / std::hypot(x, eps));
  if (contact == Contact::compliant)
    force.normal = stiffness(joint) * std::min(jump.normal, 0.);
  return force;
}

SmoothedJoint::Jump SmoothedJoint::second_derivative(const Joint &joint,
                                                     const Jump &jump) const
{
  Jump second = {0., 0.};
  const double eps = smoothing(joint);
  if (eps > 0.)
  {
    const double r = std::hypot(jump.tangential, eps);
    second.tangential = joint.strength / r * (eps / r) * (eps / r);
  }
  if (contact == Contact::compliant && jump.normal <= 0.)
    second.normal = stiffness(joint);
  return second;
}
} // namespace Voussoir
