// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/paper/smoothed_joint.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
SmoothedJoint::SmoothedJoint(const DiscreteProblem &problem,
                             const Contact contact)
    : problem(problem), contact(contact)
{
  // For hard contact any common smoothing length gives the same forces. The
  // larger of one and the strongest stress keeps displacements of order one.
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    common_smoothing = std::max(common_smoothing,
                                problem.limit(e) / problem.joints()[e].length);
}

double SmoothedJoint::smoothing(const unsigned int e) const
{
  const double b = problem.limit(e);
  if (contact == Contact::hard)
    return b > 0. ? common_smoothing : 0.;
  return b / problem.joints()[e].length * problem.joints()[e].distance;
}

double SmoothedJoint::energy(const unsigned int e, const double *jumps) const
{
  const unsigned int n = problem.n_contacts(e);
  double energy = 0.;
  const double eps = smoothing(e), x = jumps[n];
  if (eps > 0.) // sqrt(x^2 + eps^2) - eps without its cancellation
    energy += problem.limit(e) * x * (x / (std::hypot(x, eps) + eps));
  if (contact == Contact::compliant)
    for (unsigned int r = 0; r < n; ++r)
      if (jumps[r] < 0.)
        energy += 0.5 * problem.contact_stiffness(e) * jumps[r] * jumps[r];
  return energy;
}

void SmoothedJoint::find_forces(const unsigned int e,
                                const double *jumps,
                                double *forces) const
{
  const unsigned int n = problem.n_contacts(e);
  const double eps = smoothing(e), x = jumps[n];
  for (unsigned int r = 0; r < n; ++r)
    forces[r] = contact == Contact::compliant
                    ? problem.contact_stiffness(e) * std::min(jumps[r], 0.)
                    : 0.;
  forces[n] = eps > 0. ? problem.limit(e) * (x / std::hypot(x, eps)) : 0.;
}

bool SmoothedJoint::find_second_derivatives(const unsigned int e,
                                            const double *jumps,
                                            double *second) const
{
  const unsigned int n = problem.n_contacts(e);
  for (unsigned int r = 0; r < n; ++r)
    second[r] = contact == Contact::compliant && jumps[r] <= 0.
                    ? problem.contact_stiffness(e)
                    : 0.;
  const double eps = smoothing(e), root = std::hypot(jumps[n], eps);
  second[n] =
      eps > 0. ? problem.limit(e) / root * (eps / root) * (eps / root) : 0.;
  return is_isotropic(second, n);
}
} // namespace Voussoir
