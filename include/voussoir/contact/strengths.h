// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_contact_strengths_h
#define voussoir_contact_strengths_h

#include <string>
#include <vector>

namespace Voussoir
{
/** The strengths of the interfaces. */
struct Strengths
{
  /**
   * s_e of each, in the order of Packing::interfaces(): the mean of s_T over
   * the interface, not negative; S. With Coulomb's friction c_e, the mean of
   * the cohesion.
   */
  std::vector<double> of_interface;
  /** FrictionLaw::name(). */
  std::string law = {};
  /** mu_e of each, the mean of mu over the interface; empty for Tresca. */
  std::vector<double> coefficient = {};
  /** Scene::dilates. */
  bool dilate = true;
  /** f_t of each, the mean; S. Empty if all are zero; see ContactParameters. */
  std::vector<double> tensile = {};
  /** f_c of each, the mean, or infinite; S. Empty if all are infinite. */
  std::vector<double> compressive = {};
  /** Warnings to the user on means that are not exact. */
  std::vector<std::string> warnings;
};
} // namespace Voussoir

#endif
