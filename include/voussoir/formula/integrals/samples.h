// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_integrals_samples_h
#define voussoir_formula_integrals_samples_h

#include <voussoir/formula/bounds.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace Voussoir
{
/**
 * The values of a function at the points of a rule, to be compared with its
 * bounds: a peak between the points leaves no other trace.
 */
struct Samples
{
  /** Of the values seen; in their unit. */
  double least = std::numeric_limits<double>::infinity();
  /** The largest of them. */
  double most = -std::numeric_limits<double>::infinity();

  /** Look at a value. */
  void add(const double value)
  {
    least = std::min(least, value);
    most = std::max(most, value);
  }

  /**
   * True if all that @p bounds allow is near to what was seen, or they allow
   * nothing far from a linear function; true as well if they do not bound the
   * value, and nothing can be said.
   *
   * @param negligible the distance from a linear function that does not count.
   */
  bool cover(const Bounds &bounds, const double negligible) const
  {
    const Interval &range = bounds.value;
    // Points do not reach the ends of a part, a box is larger than a triangle
    // in it, and bounds are not the closest.
    constexpr double allowance = 2., rounding = 1e-9;
    const double slack = allowance * (most - least) +
                         rounding * std::max(std::abs(least), std::abs(most));
    return !std::isfinite(magnitude(range)) ||
           (range.lower() >= least - slack && range.upper() <= most + slack) ||
           width(bounds.slope[0]) + width(bounds.slope[1]) <= negligible;
  }
};

/**
 * True if the samples of functions cover their bounds, as far as these are
 * known: those of the first bounds.size() functions.
 */
inline bool cover(const std::array<Samples, 2> &samples,
                  const std::vector<Bounds> &bounds,
                  const double negligible)
{
  bool all = true;
  for (unsigned int i = 0; i < samples.size() && i < bounds.size(); ++i)
    all &= samples[i].cover(bounds[i], negligible);
  return all;
}
} // namespace Voussoir

#endif
