// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_generators_arch_profile_h
#define voussoir_packing_generators_arch_profile_h

#include <voussoir/packing/generators/arch_joints.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace Voussoir
{
/** The entries that say what an arch is between its springings. */
class ArchProfile
{
public:
  /** @param section of the entries, which messages name: "Packing/arch". */
  explicit ArchProfile(std::string section);

  /** Declare the parameters in the current subsection and bind them. */
  void add_parameters(dealii::ParameterHandler &prm);

  /**
   * The joints, from the parameters that were parsed.
   *
   * @throws InputError if these make no arch.
   */
  HalfArch joints() const;

  /** The distance from the intrados to the extrados; a length. */
  double thickness() const { return thick; }
  /** The number of voussoirs along the whole arch. */
  unsigned int n_voussoirs() const { return n; }

private:
  std::string section;
  bool pointed = false;
  double mean_radius = 1.;
  double embrace = 180.;
  double span = 2.;
  double radius_over_span = 1.;
  double thick = 0.2;
  unsigned int n = 15;
};
} // namespace Voussoir

#endif
