// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_generators_bay_crown_h
#define voussoir_packing_polyhedra_generators_bay_crown_h

#include <voussoir/packing/generators/arch_joints.h>
#include <voussoir/packing/polyhedra/generators/bay_places.h>
#include <voussoir/packing/polyhedra/generators/block_faces.h>

namespace Voussoir
{
/**
 * The course at the crown of a cross vault, if the arch has no joint there. Its
 * intrados is level, and so is its extrados unless the arch has an apex, which
 * makes a ridge along each web.
 */
class BayCrown
{
public:
  /** @param places must outlive this. */
  BayCrown(const HalfArch &arch, const BayPlaces &places);

  /** The polygon at a head joint, @p out along a web; lengths. */
  BayPlaces::Loop section(unsigned int web, double out) const;

  /** The block in the middle, with arms to the head joints at @p out. */
  BlockFaces keystone(double out) const;

  /** The part of the keystone that is in one web. */
  BlockFaces quarter(unsigned int web, double out) const;

private:
  /** Add the head, the beds, and the slopes on both sides of a ridge. */
  void add_arm(BlockFaces &block, unsigned int web, double out) const;

  const BayPlaces &places;
  bool has_ridge;
  /** The ends of the joint, and what is at the crown over them, in (a, z). */
  dealii::Point<2> inner, outer, inner_top, outer_top;
};
} // namespace Voussoir

#endif
