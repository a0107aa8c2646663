// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/contact/joint_limits.h>

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
  // With N and the lesser p at an end, both in units of f_t |e| + f_c |e|, and
  // the parts t and c of that: the root u >= 0 of
  // (N + u t)^2 = u (2 p + u t), that is c t u^2 + 2 (p - N t) u = N^2.
  const double whole = tension + crushing;
  const double t = tension / whole, c = crushing / whole;
  const double N = -(at_ends[0] + at_ends[1]) / whole;
  const double half = -std::max(at_ends[0], at_ends[1]) / whole - N * t;
  const double root = std::hypot(half, N * std::sqrt(c * t));
  if (half > 0.)
    return N * N / (half + root);
  if (N == 0. && half == 0.)
    return 0.;
  return t > 0. ? (root - half) / (c * t)
                : std::numeric_limits<double>::infinity();
}

double JointLimits::excess(const std::array<double, 2> &at_ends) const
{
  double most_tension =
      std::max({at_ends[0] - 0.5 * tension, at_ends[1] - 0.5 * tension, 0.});
  for (unsigned int k = 0; k < 2; ++k)
    if (open[k])
      most_tension = std::max(most_tension, std::abs(at_ends[k]));
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
  // An open end resists neither.
  const double start = open[0] ? 0. : openings[0] - lift,
               end = open[1] ? 0. : openings[1] - lift;
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
