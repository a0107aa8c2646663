// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/contacts/face_pair.h>

#include <algorithm>
#include <limits>
#include <tuple>

namespace Voussoir
{
namespace
{
using dealii::Point;
using dealii::Tensor;

/**
 * The least cosine between a normal and the opposite of another: beyond 30
 * degrees two faces do not face each other, but end at a common edge.
 */
constexpr double least_opposition = 0.866;

/** The unit normal midway between two that are nearly opposite. */
Tensor<1, 3> mean_normal(const FacePlane &one, const FacePlane &other)
{
  const Tensor<1, 3> twice = one.normal - other.normal;
  return twice / twice.norm();
}

/** The vertex of a ring that is nearest to a place, if it is near; or null. */
const RingCorner *
near_corner(const ConvexRing &ring, const Point<2> &at, const double distance)
{
  const RingCorner *nearest = nullptr;
  double least = distance * distance;
  for (const RingCorner &corner : ring)
  {
    const double square = corner.at.distance_square(at);
    if (square <= least)
    {
      least = square;
      nearest = &corner;
    }
  }
  return nearest;
}

/** A ring without corners next to the one before; vertices stay. */
ConvexRing distinct_corners(const ConvexRing &ring, const double distance)
{
  ConvexRing kept;
  const auto are_near = [&](const RingCorner &a, const RingCorner &b) {
    return a.at.distance_square(b.at) <= distance * distance;
  };
  for (const RingCorner &corner : ring)
    if (kept.empty() || !are_near(corner, kept.back()))
      kept.push_back(corner);
    else if (kept.back().vertex == invalid_index)
      kept.back() = corner;
  while (kept.size() > 1 && are_near(kept.back(), kept.front()))
  {
    if (kept.front().vertex == invalid_index)
      kept.front() = kept.back();
    kept.pop_back();
  }
  return kept;
}
/** The part of a polygon in which a linear function is not negative. */
template <typename Function>
ConvexRing part_above(const ConvexRing &ring, const Function &function)
{
  ConvexRing part;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const RingCorner &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const double at_p = function(p.at), at_q = function(q.at);
    if (at_p >= 0.)
      part.push_back(p);
    if ((at_p < 0. && at_q > 0.) || (at_p > 0. && at_q < 0.))
      part.push_back(
          {p.at + at_p / (at_p - at_q) * (q.at - p.at), invalid_index});
  }
  return part;
}
} // namespace

bool may_touch(const FacePlane &one,
               const FacePlane &other,
               const GapRange &range)
{
  if (!(one.normal * other.normal < -least_opposition))
    return false;
  const Tensor<1, 3> arm = other.centre - one.centre;
  const double radii = one.radius + other.radius;
  const double reach = radii + std::max(range.greatest, -range.least);
  if (arm.norm_square() > reach * reach)
    return false;
  // Both planes deviate by no more over the faces.
  const double slack = (one.normal + other.normal).norm() * radii;
  const double gap = one.normal * arm;
  return gap >= range.least - slack && gap <= range.greatest + slack;
}

PlaneHeight::PlaneHeight(const FacePlane &plane, const PlaneFrame &frame)
{
  const double cosine = plane.normal * frame.normal();
  at_origin = plane.normal * (plane.centre - frame.origin()) / cosine;
  for (unsigned int k = 0; k < 2; ++k)
    slope[k] = -(plane.normal * frame.axis(k)) / cosine;
}

FacePair::FacePair(const FaceGeometry &geometry,
                   const std::array<unsigned int, 2> &faces)
    : geometry(geometry), faces(faces),
      frame(geometry.cells.vertex(faces[0], 0),
            mean_normal(geometry.planes[faces[0]], geometry.planes[faces[1]])),
      heights{{{geometry.planes[faces[0]], frame},
               {geometry.planes[faces[1]], frame}}}
{}

bool FacePair::first_is_cut() const
{
  const auto key = [this](const unsigned int face) {
    const FacePlane &plane = geometry.planes[face];
    return std::make_tuple(plane.area, plane.centre[0], plane.centre[1],
                           plane.centre[2]);
  };
  return key(faces[0]) <= key(faces[1]);
}

void FacePair::snap(ConvexRing &ring, const ConvexRing &other) const
{
  for (RingCorner &corner : ring)
    if (const RingCorner *const near =
            near_corner(other, corner.at, geometry.tolerance))
    {
      if (corner.vertex == invalid_index)
        corner = *near;
      else // midway between the two vertices
        corner.at += 0.5 * (near->at - corner.at);
    }
}

ConvexRing
FacePair::common_part(const std::array<unsigned int, 2> &pieces) const
{
  const double tolerance = geometry.tolerance;
  ConvexRing ring = geometry.pieces.ring(pieces[0], frame);
  ConvexRing other = geometry.pieces.ring(pieces[1], frame, true);
  if (!first_is_cut())
    ring.swap(other);
  ring = Voussoir::common_part(std::move(ring), other, tolerance);
  if (!ring.empty())
  {
    snap(ring, other);
    ring = distinct_corners(ring, tolerance);
  }
  return ring;
}

ConvexRing FacePair::part_within(const ConvexRing &ring,
                                 const GapRange &range) const
{
  if (std::all_of(ring.begin(), ring.end(), [&](const RingCorner &corner) {
        const double distance = gap(corner.at);
        return distance >= range.least && distance <= range.greatest;
      }))
    return ring;
  const ConvexRing near = part_above(
      ring, [&](const Point<2> &at) { return range.greatest - gap(at); });
  return distinct_corners(
      part_above(near,
                 [&](const Point<2> &at) { return gap(at) - range.least; }),
      geometry.rounding);
}

Point<3> FacePair::place(const RingCorner &corner) const
{
  const double middle = 0.5 * (height(0, corner.at) + height(1, corner.at));
  const Point<3> place = frame.place(corner.at, middle);
  if (corner.vertex == invalid_index)
    return place;
  const Point<3> &vertex = geometry.cells.vertices[corner.vertex];
  return vertex.distance(place) <= geometry.rounding ? vertex : place;
}
} // namespace Voussoir
