// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/energy/barrier_joint.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
double BarrierJoint::slack(const unsigned int e, const double sliding) const
{
  const double w = weight(e), b = structure->limit(e);
  const double x = b * std::abs(sliding), r = std::hypot(w, x);
  return b * ((w + w * (w / (r + x))) / (w + r));
}

void BarrierJoint::find_forces(const unsigned int e,
                               const double *jumps,
                               double *forces) const
{
  const unsigned int n = structure->n_contacts(e);
  const signed char *is_fixed = &fixed[structure->first_row(e)];
  for (unsigned int r = 0; r < n; ++r)
    if (is_fixed[r] != 0)
      forces[r] = 0.;
    else
      forces[r] = jumps[r] > 0. ? -contact_weight(e) / jumps[r]
                                : -std::numeric_limits<double>::infinity();
  const double w = weight(e), b = structure->limit(e), x = jumps[n];
  forces[n] = is_fixed[n] != 0 ? is_fixed[n] * b
                               : b * (b * x / (w + std::hypot(w, b * x)));
}

bool BarrierJoint::find_second_derivatives(const unsigned int e,
                                           const double *jumps,
                                           double *second) const
{
  const unsigned int n = structure->n_contacts(e);
  const signed char *is_fixed = &fixed[structure->first_row(e)];
  for (unsigned int r = 0; r < n; ++r)
    second[r] = is_fixed[r] != 0 ? 0. : contact_weight(e) / jumps[r] / jumps[r];
  const double w = weight(e), b = structure->limit(e);
  const double root = std::hypot(w, b * jumps[n]);
  second[n] = is_fixed[n] != 0 ? 0. : b * (w / root) * (b / (w + root));
  return is_isotropic(second, n);
}

double BarrierJoint::longest_step(const unsigned int e,
                                  const double *jumps,
                                  const double *steps) const
{
  const unsigned int n = structure->n_contacts(e);
  const signed char *is_fixed = &fixed[structure->first_row(e)];
  double longest = std::numeric_limits<double>::infinity();
  for (unsigned int r = 0; r < n; ++r)
    if (is_fixed[r] == 0 && steps[r] < 0.)
      longest = std::min(longest, -jumps[r] / steps[r]);
  return longest;
}
} // namespace Voussoir
