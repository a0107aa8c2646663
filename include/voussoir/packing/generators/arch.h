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
 * A pier is as wide as the arch is thick, or wider, and its inner face is flush
 * with the intrados. Under an inclined springing its top course is a skewback:
 * a block that ends in the springing and, at the height of the extrados, in a
 * ledge from there to the outer face. A ledge that would be very narrow is left
 * out, and the pier ends below the extrados. The abutment height is that of the
 * inner face, from the ground to the springing, divided evenly by the courses.
 *
 * Rings divide the thickness evenly. They have their radial joints in common,
 * and between two rings one straight joint a voussoir. The apex of a pointed
 * arch belongs to the outermost ring.
 *
 * Cells are numbered along the arch: up the left pier, over the arch, at each
 * place from the inside to the outside, down the right pier. So c and n_cells -
 * 1 - c are mirror images in an arch of one ring, to the last bit. Cells belong
 * to the groups "voussoir", "keystone" (the voussoir at the crown, if their
 * number is odd) and "abutment"; those of several rings to "ring 1", the
 * innermost, "ring 2" and so on, and "abutment".
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

  /**
   * The place of a cell along the arch plus the number of its ring, which
   * differs by one from cell to cell along a ring, and across it: odd and even
   * cells overlap in a vault in running bond.
   */
  unsigned int rank_of(unsigned int cell) const;

private:
  /**
   * The width of the piers; a length.
   *
   * @throws InputError if they are narrower than the arch is thick.
   */
  double width_of_piers() const;

  std::string section;
  ArchProfile profile;
  unsigned int n_rings = 1;
  unsigned int n_abutment_courses = 0;
  double abutment_height = 1.;
  double abutment_width = 0.;
};
} // namespace Voussoir

#endif
