// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_generators_vault_h
#define voussoir_packing_polyhedra_generators_vault_h

#include <voussoir/packing/generators/arch.h>
#include <voussoir/packing/generators/bond.h>
#include <voussoir/packing/generators/generator.h>

namespace Voussoir
{
/**
 * A barrel vault: an arch in the plane of x and z, with or without piers, that
 * goes along y from 0 to the length. It is symmetric to x = 0.
 *
 * The arch is that of ArchGenerator, with its y for z, and so are the joints
 * and the springings: on z = 0 if it is pointed or embraces 180 degrees,
 * otherwise on planes through the axis of y. Each of its voussoirs becomes a
 * row of blocks along y. Blocks are prisms, all convex, with chords of the
 * intrados and the extrados for faces; the volume is that of the arch's area
 * times the length. One block in a row, in stack bond, makes an arch.
 *
 * Cells are numbered row by row over the arch, from the ground at x < 0 up and
 * down again to that at x > 0, and in a row along y. They belong to the groups
 * of the arch. In running bond rows that touch overlap, also those of two
 * rings.
 */
class VaultGenerator : public PackingGenerator<3>
{
public:
  std::string name() const override { return "vault"; }
  std::string meaning() const override
  {
    return "a barrel vault, or an arch, with or without piers.";
  }
  void add_parameters(dealii::ParameterHandler &prm) override;
  CellFaces generate(const std::filesystem::path &directory,
                     Terminal &terminal) const override;

private:
  ArchGenerator arch{"Packing/vault"};
  Bond bond = Bond::running;
  double length = 2.;
  unsigned int n_in_row = 6;
};
} // namespace Voussoir

#endif
