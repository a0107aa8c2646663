// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_generators_cross_vault_h
#define voussoir_packing_polyhedra_generators_cross_vault_h

#include <voussoir/packing/generators/arch_profile.h>
#include <voussoir/packing/generators/bond.h>
#include <voussoir/packing/generators/generator.h>

namespace Voussoir
{
/**
 * A cross vault over a square bay around the axis of z: two barrel vaults with
 * the same arch for profile, one along y and one along x. The vertical planes
 * x = y and x = -y, in which the groins lie, cut them into four webs. The one
 * at y > 0 is what the barrel along y has between |x| and H, where H is half
 * the width of the bay: half that of the extrados at the springings, and the
 * extension. The other webs are this one turned by right angles.
 *
 * The arch is that of ArchGenerator, with its y for z: its voussoirs make
 * courses, each at the same height in all webs. Two courses of neighbouring
 * webs meet in the same polygon of the plane of the groin, so that all joints
 * fit exactly, whether blocks end there or go over it. All faces are plane:
 *
 * - Between the groins and the ends of the webs blocks are prisms, cut off by
 *   head joints across the barrel. Those are H/b apart for b blocks, counted
 *   from the ends of the webs; in running bond they are shifted by half of that
 *   in every second course, counted from the springings.
 * - With groin blocks, one block of each course lies across each groin, has a
 *   leg in either web and is not convex. Its legs end at the first head joint
 *   that leaves them a quarter of a block's length along the extrados. If the
 *   number of voussoirs is odd, the four courses at the crown meet in one
 *   keystone in the shape of a cross.
 * - With mitre joints, the same blocks are cut by the planes of the groins, and
 *   all blocks are convex.
 *
 * A circular arch of n voussoirs, the mean radius R, the thickness t and the
 * embrace E has the area A = n sin(d) R t with d = E/n, and the integral M of
 * |x| over that, which is a cos(d/2)^2 (1 - cos(E/2)) 2/3 if n is even and
 * a cos(d/2) (2 cos(d/2) (cos(d/2) - cos(E/2)) + sin(d/2)^2)/3 if it is odd,
 * where a = (R+t/2)^3 - (R-t/2)^3. The vault's volume is 4 (H A - M).
 *
 * It springs from four corners. If the springings are level, it stands on z = 0
 * there, on squares as wide as t, and, if there is an extension, on strips as
 * wide as t along both sides. Otherwise it stands on two planes a corner, which
 * contain a line in direction of x or y and a radius of the arch.
 *
 * A rectangular bay is the square one stretched along y. The profile of the
 * barrel along x is then half an ellipse if the arch is half a circle, and its
 * joints are not normal to that.
 *
 * Cells are numbered course by course from the springings up; in a course
 * corner by corner, counterclockwise as seen from above from that at x < 0 and
 * y > 0 on, and there first what is at the groin, then web by web outwards. At
 * the crown the keystone comes first. They belong to the groups "voussoir",
 * "groin" and "keystone"; with mitre joints the four blocks that meet in the
 * middle of the crown are of the last.
 */
class CrossVaultGenerator : public PackingGenerator<3>
{
public:
  std::string name() const override { return "cross vault"; }
  std::string meaning() const override
  {
    return "two barrel vaults that cross over a bay.";
  }
  void add_parameters(dealii::ParameterHandler &prm) override;
  CellFaces generate(const std::filesystem::path &directory,
                     Terminal &terminal) const override;

private:
  ArchProfile profile{"Packing/cross vault"};
  double extension = 0.;
  double depth_over_width = 1.;
  unsigned int n_blocks = 4;
  Bond bond = Bond::running;
  bool mitred = false;
};
} // namespace Voussoir

#endif
