// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/barrier_joint.h>

#include <cmath>
#include <limits>

namespace Voussoir
{
BarrierJoint::BarrierJoint(const Structure &structure,
                           const BarrierWeights weights)
    : fixed(structure.joints().size()), structure(&structure), weights(weights)
{
}

double BarrierJoint::weight(const unsigned int e) const
{
  const Structure::Joint &joint = structure->joints()[e];
  return weights == BarrierWeights::equal ? 1. : joint.length * joint.distance;
}

double BarrierJoint::slack(const unsigned int e, const Jump &jump) const
{
  const double w = weight(e), b = structure->joints()[e].strength;
  const double x = b * std::abs(jump.tangential), r = std::hypot(w, x);
  return b * ((w + w * (w / (r + x))) / (w + r));
}

JointLaw::Jump BarrierJoint::force(const unsigned int e, const Jump &jump) const
{
  const double w = weight(e), b = structure->joints()[e].strength;
  Jump force = {0., 0.};
  if (!fixed[e].never_pressed)
    force.normal = jump.normal > 0. ? -w / jump.normal
                                    : -std::numeric_limits<double>::infinity();
  if (fixed[e].sliding != 0)
    force.tangential = fixed[e].sliding * b;
  else
    force.tangential =
        b * (b * jump.tangential / (w + std::hypot(w, b * jump.tangential)));
  return force;
}

JointLaw::Jump BarrierJoint::second_derivative(const unsigned int e,
                                               const Jump &jump) const
{
  const double w = weight(e), b = structure->joints()[e].strength;
  Jump second = {0., 0.};
  if (!fixed[e].never_pressed)
    second.normal = w / jump.normal / jump.normal;
  if (fixed[e].sliding == 0)
  {
    const double r = std::hypot(w, b * jump.tangential);
    second.tangential = b * (w / r) * (b / (w + r));
  }
  return second;
}

double BarrierJoint::longest_step(const unsigned int e,
                                  const Jump &jump,
                                  const Jump &step) const
{
  return fixed[e].never_pressed || step.normal >= 0.
             ? std::numeric_limits<double>::infinity()
             : -jump.normal / step.normal;
}
} // namespace Voussoir
