// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_generators_arch_joints_h
#define voussoir_packing_generators_arch_joints_h

#include <deal.II/base/point.h>

#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** A joint across an arch, normal to its middle line. */
struct ArchJoint
{
  dealii::Point<2> intrados; /**< its end on the inner face; lengths */
  dealii::Point<2> extrados; /**< its end on the outer face; lengths */
};

/** The left half of an arch that is symmetric to x = 0. */
struct HalfArch
{
  /**
   * From the left springing to the crown. The last joint lies on x = 0 if the
   * number of voussoirs is even; if it is odd, the keystone lies between the
   * last joint and its mirror image.
   */
  std::vector<ArchJoint> joints;
  /** The extrados of the keystone at x = 0, if it has a vertex there. */
  std::optional<dealii::Point<2>> apex;
};

/**
 * A circular arch around the origin: n+1 joints at equal angles, on radii.
 * The springings of a semicircle lie on y = 0.
 *
 * @param section of its entries, which a message names: "Packing/arch".
 * @param mean_radius of the middle line; a length.
 * @param thickness a length.
 * @param n_voussoirs n, at least 2.
 * @param embrace the angle from springing to springing; degrees, at most 180.
 * @throws InputError if the intrados has no radius.
 */
HalfArch circular_arch(const std::string &section,
                       double mean_radius,
                       double thickness,
                       unsigned int n_voussoirs,
                       double embrace);

/**
 * A pointed arch with its springings on y = 0: two arcs whose centres lie on
 * y = 0, at equal distances from x = 0. The joints are on radii of the arcs and
 * divide the middle line into n equal parts; where n is even, the joint at the
 * crown is vertical instead.
 *
 * @param section of its entries, which a message names: "Packing/arch".
 * @param span of the middle line; a length.
 * @param radius_over_span radius of the middle line's arcs over the span, at
 *   least 1/2, a semicircle; 1 is an equilateral arch.
 * @param thickness a length.
 * @param n_voussoirs n, at least 2.
 * @throws InputError if the arch has no clear span, or if the joints next to
 *   the crown would reach over it.
 */
HalfArch pointed_arch(const std::string &section,
                      double span,
                      double radius_over_span,
                      double thickness,
                      unsigned int n_voussoirs);
} // namespace Voussoir

#endif
