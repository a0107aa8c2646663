// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/energy/section.h>

#include <algorithm>
#include <array>

namespace Voussoir
{
namespace
{
/** Where a section goes over from one state to the next, with its ends. */
using Places = std::array<double, 4>;

/** The place where a linear function has the value zero, within the section. */
double zero_of(const double at_start, const double at_end)
{
  const double place = at_start / (at_start - at_end);
  return std::clamp(place, 0., 1.);
}

/** The places where the elastic stress meets its limits, in order. */
Places places_of(const double at_start,
                 const double at_end,
                 const NormalLimits &limits)
{
  if (at_start == at_end)
    return {{0., 0., 1., 1.}};
  Places places = {
      {0., zero_of(at_start - limits.tension, at_end - limits.tension),
       zero_of(at_start + limits.crushing, at_end + limits.crushing), 1.}};
  std::sort(places.begin() + 1, places.end() - 1);
  return places;
}
} // namespace

Section::Forces Section::forces(const double g_start, const double g_end) const
{
  const double at_start = stiffness_of_joint * g_start;
  const double at_end = stiffness_of_joint * g_end;
  const auto stress = [&](const double s) {
    return std::clamp(at_start + s * (at_end - at_start), -limits.crushing,
                      limits.tension);
  };
  const Places places = places_of(at_start, at_end, limits);
  Forces sum = {0., 0.};
  for (unsigned int k = 1; k < places.size(); ++k)
  {
    // A piece on which the stress is linear.
    const double a = places[k - 1], b = places[k];
    const double at_a = stress(a), at_b = stress(b);
    const double sixth = (b - a) / 6.;
    sum.at_start += sixth * (at_a * (2. * (1. - a) + (1. - b)) +
                             at_b * ((1. - a) + 2. * (1. - b)));
    sum.at_end += sixth * (at_a * (2. * a + b) + at_b * (a + 2. * b));
  }
  return sum;
}

Section::Stiffness Section::stiffness(const double g_start,
                                      const double g_end) const
{
  const double at_start = stiffness_of_joint * g_start;
  const double at_end = stiffness_of_joint * g_end;
  const Places places = places_of(at_start, at_end, limits);
  // Between the two limits, unless all of it is beyond one of them.
  const double a = places[1], b = places[2];
  const double in_middle = at_start + 0.5 * (a + b) * (at_end - at_start);
  if (in_middle < -limits.crushing || in_middle > limits.tension)
    return {0., 0., 0.};
  const double length = b - a;
  const double first = 0.5 * length * (a + b);
  const double second = length * (a * a + a * b + b * b) / 3.;
  return {stiffness_of_joint * (length - 2. * first + second),
          stiffness_of_joint * second, stiffness_of_joint * (first - second)};
}
} // namespace Voussoir
