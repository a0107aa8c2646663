// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_friction_law_h
#define voussoir_algebra_friction_law_h

#include <algorithm>
#include <cmath>
#include <string>

namespace Voussoir
{

/**
 * The forces that a joint admits: f_e^n <= 0, and |f_e^t| up to a limit. All in
 * the unit of the strength s_e |e|, which is the parameter of a joint.
 */
class FrictionLaw
{
public:
  virtual ~FrictionLaw() = default;
  /** The name, for the processes to agree on it; see friction_law_of(). */
  virtual std::string name() const = 0;
  /** The largest |f_e^t| under the @p compression -f_e^n, not negative. */
  virtual double limit(double strength, double compression) const = 0;

  /** The excess of forces over their limits; not negative. */
  double violation(const double strength,
                   const double normal,
                   const double tangential) const
  {
    return std::max(
        {0., normal, std::abs(tangential) - limit_at(strength, normal)});
  }
  /** The tangential force nearest to @p tangential that is admitted. */
  double projection(const double strength,
                    const double normal,
                    const double tangential) const
  {
    const double largest = limit_at(strength, normal);
    return std::clamp(tangential, -largest, largest);
  }
  /** The part of the limit in use; zero without a tangential force. */
  double utilisation(const double strength,
                     const double normal,
                     const double tangential) const
  {
    const double q = std::abs(tangential);
    return q > 0. ? q / limit_at(strength, normal) : 0.;
  }
  /** The work that friction takes out of a @p sliding. */
  double dissipation(const double strength, const double sliding) const
  {
    return limit(strength, 0.) * std::abs(sliding);
  }

private:
  double limit_at(const double strength, const double normal) const
  {
    return limit(strength, std::max(-normal, 0.));
  }
};

/** The friction of Tresca, |f_e^t| <= s_e |e|. */
const FrictionLaw &tresca();

/** The law of that name among those that there are. */
const FrictionLaw &friction_law_of(const std::string &name);

} // namespace Voussoir

#endif
