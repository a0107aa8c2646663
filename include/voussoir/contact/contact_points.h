// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_contact_contact_points_h
#define voussoir_contact_contact_points_h

#include <vector>

namespace Voussoir
{
/** A point of an interface at which its blocks touch. */
struct ContactPoint
{
  /** Zero at the start of the interface, one at its end. */
  double place;
};

/** The points of an interface, at which its forces act. */
struct ContactPoints
{
  /** Where it bears pressure; they share its stiffness equally. */
  std::vector<ContactPoint> pressure;
  /** Where it slides: the tangential force acts all along the line. */
  ContactPoint friction;
};

/**
 * The points of an interface in the plane. Blocks that do not turn touch at its
 * midpoint. Those that do touch at both of its ends: contact there is contact
 * all along it, since the opening of an interface is linear, and any pressure
 * on it has the resultant of two forces there. Its sliding is the same
 * everywhere, (x - x_c) . n_e being constant.
 */
const ContactPoints &contact_points(bool blocks_turn);
} // namespace Voussoir

#endif
