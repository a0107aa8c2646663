// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/scene/joint_limits.h>

#include <cmath>

namespace Voussoir
{
namespace
{
/**
 * The largest N closing + |M turning| of the forces N and moments M of a
 * section of unit length, |M| <= N (1 - N / strength) / 2.
 */
double most_of_section(const double strength,
                       const double closing,
                       const double turning)
{
  if (!(turning > 0.))
    return strength * std::max(closing, 0.);
  const double part = std::clamp(0.5 + closing / turning, 0., 1.);
  return strength * part * (closing + 0.5 * turning * (1. - part));
}
} // namespace

double
JointLimits::crushing_utilisation(const std::array<double, 2> &at_ends) const
{
  if (!std::isfinite(crushing))
    return 0.;
  const double p[] = {0.5 * tension - at_ends[0], 0.5 * tension - at_ends[1]};
  const double N = p[0] + p[1];
  return N > 0. ? N / (tension + crushing) * N / (2. * std::min(p[0], p[1]))
                : 0.;
}

double JointLimits::excess(const std::array<double, 2> &at_ends) const
{
  const double most_tension =
      std::max({at_ends[0] - 0.5 * tension, at_ends[1] - 0.5 * tension, 0.});
  if (!std::isfinite(crushing))
    return most_tension;
  const double p[] = {0.5 * tension - at_ends[0], 0.5 * tension - at_ends[1]};
  const double N = p[0] + p[1];
  if (!(N > 0.))
    return most_tension;
  const double most =
      (tension + crushing) * 2. * std::max(std::min(p[0], p[1]), 0.) / N;
  return std::max(most_tension, N - most);
}

JointLimits::Resistance
JointLimits::resistance(const std::array<double, 2> &openings,
                        const double sliding) const
{
  // Joints with a coefficient open as they slide.
  const double lift = coefficient * std::abs(sliding);
  const double start = openings[0] - lift, end = openings[1] - lift;
  Resistance of = {(strength - coefficient * tension) * std::abs(sliding), 0.};
  if (tension > 0.)
    of.dissipation += 0.5 * tension * (openings[0] + openings[1]);
  if (std::isfinite(crushing))
    of.dissipation += most_of_section(tension + crushing, -0.5 * (start + end),
                                      std::abs(start - end));
  else
    of.closing = std::max({0., -start, -end});
  return of;
}
} // namespace Voussoir
