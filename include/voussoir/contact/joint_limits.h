// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_contact_joint_limits_h
#define voussoir_contact_joint_limits_h

#include <algorithm>
#include <array>
#include <limits>

namespace Voussoir
{
/**
 * The forces that an interface admits, by closed forms in the user's units.
 *
 * The stress on it lies between f_t and -f_c wherever it is pressed or pulled,
 * as in a rigid-plastic section: with N = -f_e^n and the eccentricity e_N of
 * the resultant
 *
 *     N >= -f_t |e|  and, without tension,  N <= f_c (|e| - 2 |e_N|),
 *
 * and |f_e^t| <= c |e| + mu N. Where blocks do not turn e_N counts as zero.
 */
struct JointLimits
{
  /** s_e |e|, or c_e |e| with Coulomb's friction; S L. */
  double strength;
  /** mu_e. */
  double coefficient = 0.;
  /** f_t |e|; S L. */
  double tension = 0.;
  /** f_c |e|; S L. */
  double crushing = std::numeric_limits<double>::infinity();
  /**
   * Whether its start and its end are open, and bear nothing; then it has
   * friction by its coefficient alone.
   */
  std::array<bool, 2> open = {{false, false}};

  /** The largest |f_e^t| under the normal force f_e^n; S L. */
  double shear_strength(const double normal) const
  {
    return std::max(strength - coefficient * normal, 0.);
  }
  /**
   * The part of the section that is in use: the least u for which the limits of
   * the normal forces, with u f_t and u f_c instead of f_t and f_c, admit them.
   * So 1/u times these forces, at the same eccentricity, are at the limit, also
   * where that is one of tension. Zero if the section does not crush; infinite
   * if without tension the resultant is at an end or outside.
   *
   * @param at_ends the normal force at its ends, not positive in compression.
   */
  double crushing_utilisation(const std::array<double, 2> &at_ends) const;
  /**
   * The excess of normal forces over their limits; not negative. At an end that
   * is open all of it is too much.
   *
   * @param at_ends as above.
   */
  double excess(const std::array<double, 2> &at_ends) const;
  /** What the forces do against a motion. */
  struct Resistance
  {
    /** The most that they can take out of it; S L times its unit. */
    double dissipation;
    /** The closing that forces without bound resist; its unit. */
    double closing;
  };
  /**
   * The support function of the set of forces.
   *
   * @param openings at the ends, negative where it closes.
   * @param sliding of any sign.
   */
  Resistance resistance(const std::array<double, 2> &openings,
                        double sliding) const;
};
} // namespace Voussoir

#endif
