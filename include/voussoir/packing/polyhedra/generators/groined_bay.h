// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_generators_groined_bay_h
#define voussoir_packing_polyhedra_generators_groined_bay_h

#include <voussoir/packing/generators/arch_joints.h>
#include <voussoir/packing/generators/bond.h>
#include <voussoir/packing/polyhedra/cell_faces.h>

namespace Voussoir
{
/** The plan of a cross vault, and how it is cut into blocks. */
struct GroinedBay
{
  /** Distance from the middle to where the webs end, along x; a length. */
  double half_width;
  /** That along y over that along x. */
  double depth_over_width = 1.;
  /** The number of blocks along half_width. */
  unsigned int n_blocks;
  /** Running, or stack. */
  Bond bond = Bond::running;
  /** Whether blocks end at the groins; otherwise they reach over them. */
  bool mitred = false;
};

/**
 * The blocks of a cross vault; see CrossVaultGenerator for their shapes, their
 * order and their groups.
 *
 * @param arch in the plane of x and z, with its y for z.
 * @param bay is as wide as the extrados of the arch at least.
 */
CellFaces cells_of_bay(const HalfArch &arch, const GroinedBay &bay);
} // namespace Voussoir

#endif
