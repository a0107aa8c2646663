// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_generators_dome_h
#define voussoir_packing_polyhedra_generators_dome_h

#include <voussoir/packing/generators/arch_joints.h>
#include <voussoir/packing/generators/bond.h>
#include <voussoir/packing/generators/generator.h>

#include <vector>

namespace Voussoir
{
/**
 * A dome of courses around the axis of z, whose vertices lie on two spheres
 * around the origin: those of the intrados on that of radius R - t/2, those of
 * the extrados on that of radius R + t/2.
 *
 * Joints are given in the half plane of the distance r from the axis and of z,
 * and go around the axis in flat facets, F in all: a block is bounded by
 * isosceles trapezoids, which are plane, between the meridian planes at the
 * angles 2 pi j/F, and the first of these contains the axis of x. So all joints
 * fit exactly:
 *
 * - In stack bond a block has one facet, F is the number m of sectors, and
 *   blocks are convex.
 * - In running bond a block has two, F = 2m; every second course is shifted by
 *   one. Blocks have an edge in their middle and are not convex; each lies with
 *   one facet on one block of the next course and with the other on another.
 *
 * Facets are numbered from the axis of x on, and blocks of a course begin with
 * facet 0, or with 1 in every second one of a running bond.
 *
 * Radial bed joints are on lines through the origin. The angle from the axis to
 * the joints of the foot is half the embrace, E/2; to those of the crown half
 * that of the oculus, or, with a keystone, E/2/(2n+1), for n courses, so that
 * the keystone is as wide as a course; the others are at equal angles. A facet
 * between the angles a and b has the volume
 * ((R+t/2)^3 - (R-t/2)^3) (sin a + sin b) sin(b-a) sin(2 pi/F)/6, a keystone
 * ((R+t/2)^3 - (R-t/2)^3) F sin(a)^2 cos(a) sin(2 pi/F)/6.
 *
 * Horizontal bed joints, as in a corbelled dome, go from the inner sphere to
 * the outer one, at equal heights between the same points of the intrados at
 * the crown and at the foot. The keystone then is a lid on the first course:
 * from that joint, as far as its end on the outer sphere, to the point of this
 * that is at the angle of the crown.
 *
 * The foot stands on z = (R-t/2) cos(E/2), which is 0 for a hemisphere, if the
 * joints are horizontal or E is 180 degrees; otherwise on F planes, one a
 * facet.
 *
 * Cells are numbered course by course from the crown down, the keystone first,
 * and in a course around the axis counterclockwise as seen from above. They
 * belong to the groups "voussoir" and "keystone".
 */
class DomeGenerator : public PackingGenerator<3>
{
public:
  std::string name() const override { return "dome"; }
  std::string meaning() const override
  {
    return "a dome with a keystone or an oculus.";
  }
  void add_parameters(dealii::ParameterHandler &prm) override;
  CellFaces generate(const std::filesystem::path &directory,
                     Terminal &terminal) const override;

private:
  /** The joints of a meridian from the crown down, in (r, z), if radial. */
  std::vector<ArchJoint> radial_joints() const;
  /** The joints of a meridian from the crown down, in (r, z). */
  std::vector<ArchJoint> joints() const;
  /** Refuse what is no dome. */
  void check_parameters() const;

  double mean_radius = 1.;
  double thickness = 0.2;
  double embrace = 180.;
  bool has_keystone = true;
  double oculus = 30.;
  unsigned int n_courses = 10;
  unsigned int n_sectors = 16;
  Bond bond = Bond::running;
  bool level_beds = false;
};
} // namespace Voussoir

#endif
