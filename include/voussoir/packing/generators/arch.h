// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_generators_arch_h
#define voussoir_packing_generators_arch_h

#include <voussoir/packing/generators/arch_profile.h>
#include <voussoir/packing/generators/generator.h>

namespace Voussoir
{
/**
 * An arch of straight-sided voussoirs, symmetric to x = 0, with or without
 * piers under its springings.
 *
 * A circular arch has its centre at the origin; a pointed one its springings on
 * y = 0. See circular_arch() and pointed_arch() for the joints. The keystone of
 * a pointed arch has a straight intrados and the apex of the extrados.
 *
 * A pier is as wide as the arch is thick, and its inner face is flush with the
 * intrados. Under an inclined springing its top course is a skewback: a block
 * that ends in the springing and, at the height of the extrados, in a ledge
 * from there to the outer face. A ledge that would be very narrow is left out,
 * and the pier ends below the extrados. The abutment height is that of the
 * inner face, from the ground to the springing, divided evenly by the courses.
 *
 * Cells are numbered along the arch: up the left pier, over the arch, down the
 * right pier, so that c and n_cells - 1 - c are mirror images, to the last bit.
 * They belong to the groups "voussoir", "keystone" (the voussoir at the crown,
 * if their number is odd) and "abutment".
 */
class ArchGenerator : public PackingGenerator<2>
{
public:
  /** @param section of the entries, which messages name. */
  explicit ArchGenerator(const std::string &section = "Packing/arch");

  std::string name() const override { return "arch"; }
  std::string meaning() const override
  {
    return "a circular or a pointed arch, with or without piers.";
  }
  void add_parameters(dealii::ParameterHandler &prm) override;
  CellLoops generate(const std::filesystem::path &directory,
                     Terminal &terminal) const override;

private:
  std::string section;
  ArchProfile profile;
  unsigned int n_abutment_courses = 0;
  double abutment_height = 1.;
};
} // namespace Voussoir

#endif
