// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_contacts_face_outline_h
#define voussoir_packing_polyhedra_contacts_face_outline_h

#include <voussoir/packing/polyhedra/contacts/face_geometry.h>

#include <array>
#include <vector>

namespace Voussoir
{
/** A part of a segment, from 0 at its begin to 1 at its end. */
using SegmentPart = std::array<double, 2>;

/** The polygon of a face, convex or not, in its plane. */
class FaceOutline
{
public:
  /** @param geometry must outlive this object. */
  FaceOutline(const FaceGeometry &geometry, unsigned int face);

  /** The height of a place above the plane, outside the cell; a length. */
  double height(const dealii::Point<3> &place) const
  {
    return frame.height(place) - height_of_plane;
  }
  /** How far the foot of a place is inside of all sides; negative outside. */
  double depth(const dealii::Point<3> &place) const
  {
    return depth(frame.project(place));
  }
  /**
   * The parts of a segment whose feet are inside. What is nowhere farther from
   * the sides than the tolerance, or no longer than that, is none.
   */
  std::vector<SegmentPart> parts_inside(const dealii::Point<3> &begin,
                                        const dealii::Point<3> &end) const;

private:
  double depth(const dealii::Point<2> &at) const;

  double tolerance;
  PlaneFrame frame;
  double height_of_plane;
  std::vector<dealii::Point<2>> corners;
};

/**
 * The part of a segment that is as near to a convex polygon in space as
 * @p distance, a length, above it and beside it; its begin is behind its end if
 * there is none.
 */
SegmentPart part_near(const dealii::ArrayView<const dealii::Point<3>> &polygon,
                      const dealii::Tensor<1, 3> &normal,
                      const std::array<dealii::Point<3>, 2> &segment,
                      double distance);
} // namespace Voussoir

#endif
