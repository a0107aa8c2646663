// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_contacts_face_pair_h
#define voussoir_packing_polyhedra_contacts_face_pair_h

#include <voussoir/packing/polyhedra/contacts/face_geometry.h>

#include <array>

namespace Voussoir
{
/** The distances at which two faces touch, from the first to the second. */
struct GapRange
{
  /** The least, negative where they may overlap; a length. */
  double least;
  /** The greatest; a length. */
  double greatest;
};

/**
 * True unless two faces cannot touch: their normals are not nearly opposite,
 * or the faces are too far from each other along them or beside them.
 */
bool may_touch(const FacePlane &one,
               const FacePlane &other,
               const GapRange &range);

/** The height of a plane as a linear function of coordinates in a frame. */
class PlaneHeight
{
public:
  /** @param plane one whose normal is not in the plane of the frame. */
  PlaneHeight(const FacePlane &plane, const PlaneFrame &frame);

  /** The height at a place; a length. */
  double operator()(const dealii::Point<2> &at) const
  {
    return at_origin + slope * at;
  }

private:
  double at_origin;
  dealii::Tensor<1, 2> slope;
};

/**
 * Two faces of different cells, the normals of which are nearly opposite, seen
 * from outside the first along the mean of their normals.
 */
class FacePair
{
public:
  /**
   * @param geometry must outlive this object.
   * @param faces the two, that of the lower cell first.
   */
  FacePair(const FaceGeometry &geometry,
           const std::array<unsigned int, 2> &faces);

  /**
   * What a piece of the first face has in common with one of the second, as
   * seen along the normal; empty if that is nothing.
   */
  ConvexRing common_part(const std::array<unsigned int, 2> &pieces) const;
  /**
   * The part of a common polygon in which the distance of the faces is in a
   * range: the very polygon, or what two straight lines cut off, since the
   * distance is linear; empty if there is none.
   */
  ConvexRing part_within(const ConvexRing &ring, const GapRange &range) const;

  /** The coordinates in which the two are compared. */
  const PlaneFrame &coordinates() const { return frame; }
  /** The numbers of the faces, that of the lower cell first. */
  const std::array<unsigned int, 2> &numbers() const { return faces; }
  /** The height of the first face, 0, or of the second, 1; a length. */
  double height(const unsigned int k, const dealii::Point<2> &at) const
  {
    return heights[k](at);
  }
  /** The distance from the first to the second; a length. */
  double gap(const dealii::Point<2> &at) const
  {
    return heights[1](at) - heights[0](at);
  }
  /**
   * The place of a corner midway between the faces: the very vertex if it is
   * one that lies there.
   */
  dealii::Point<3> place(const RingCorner &corner) const;

private:
  /** True if the first face is the one that is cut by the sides of the other,
   * whatever the numbers of the two. */
  bool first_is_cut() const;
  /** Move corners to vertices of the polygon that cut them. */
  void snap(ConvexRing &ring, const ConvexRing &other) const;

  const FaceGeometry &geometry;
  std::array<unsigned int, 2> faces;
  PlaneFrame frame;
  std::array<PlaneHeight, 2> heights;
};
} // namespace Voussoir

#endif
