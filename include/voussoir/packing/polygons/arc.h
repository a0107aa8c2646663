// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_arc_h
#define voussoir_packing_polygons_arc_h

#include <deal.II/base/point.h>

namespace Voussoir
{
/** An arc of a circle. */
struct Arc
{
  dealii::Point<2> start; /**< a length */
  dealii::Point<2> end;   /**< a length */
  /**
   * The tangent of a quarter of the angle that it turns by, positive if to the
   * left, as DXF has it; not zero.
   */
  double bulge;

  /** The angle that it turns by, positive to the left. */
  double angle() const;
  /** A length. */
  double radius() const;
  /** A length. */
  dealii::Point<2> centre() const;
  /** The point where @p turned of the angle is turned by; a length. */
  dealii::Point<2> at(double turned) const;
  /** The point where half of the angle is turned by; a length. */
  dealii::Point<2> middle() const { return at(0.5 * angle()); }
  /** The unsigned angle from the start on at which @p p lies, below 2 pi. */
  double angle_to(const dealii::Point<2> &p) const;
  /** The same arc from its end to its start. */
  Arc reversed() const { return {end, start, -bulge}; }
};

/**
 * The bulge of the arc from @p start through @p middle to @p end, three
 * different points.
 */
double bulge_through(const dealii::Point<2> &start,
                     const dealii::Point<2> &middle,
                     const dealii::Point<2> &end);
} // namespace Voussoir

#endif
