// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/contacts/joint_sight.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::Point;

/** A corner of a face that may be in a joint. */
struct LiftedCorner
{
  /** Its coordinates in the frame of the joint; lengths. */
  Point<2> at;
  /** Its height above the first face, and the depth below the second. */
  std::array<double, 2> clearance;
};
using LiftedRing = boost::container::small_vector<LiftedCorner, 8>;

/** The part of a polygon where a clearance is at least a margin. */
LiftedRing part_that_clears(const LiftedRing &ring,
                            const unsigned int k,
                            const double margin)
{
  LiftedRing kept;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const LiftedCorner &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const double at_p = p.clearance[k] - margin, at_q = q.clearance[k] - margin;
    if (at_p >= 0.)
      kept.push_back(p);
    if ((at_p < 0. && at_q > 0.) || (at_p > 0. && at_q < 0.))
    {
      const double t = at_p / (at_p - at_q);
      LiftedCorner between{p.at + t * (q.at - p.at), {}};
      for (unsigned int j = 0; j < 2; ++j)
        between.clearance[j] =
            p.clearance[j] + t * (q.clearance[j] - p.clearance[j]);
      kept.push_back(between);
    }
  }
  return kept;
}

/** True if two polygons have the same corners to the last bit. */
bool is_same(const ConvexRing &one, const ConvexRing &other)
{
  return std::equal(
      one.begin(), one.end(), other.begin(), other.end(),
      [](const RingCorner &a, const RingCorner &b) { return a.at == b.at; });
}

/** Finds what covers one joint; one object, used once. */
class JointSight
{
public:
  JointSight(const FaceGeometry &geometry, const FacePair &pair)
      : geometry(geometry), pair(pair)
  {
    for (unsigned int k = 0; k < 2; ++k)
      cells[k] = geometry.cells.cell_of_face(pair.numbers()[k]);
  }

  ConvexRings parts(const ConvexRing &ring) const
  {
    const SpaceBox box = box_of(ring);
    ConvexRings open = {ring};
    for (const unsigned int cell : geometry.boxes.touching(box))
      for (unsigned int f = geometry.cells.first_face[cell];
           f < geometry.cells.first_face[cell + 1]; ++f)
        if (f != pair.numbers()[0] && f != pair.numbers()[1] &&
            common_extent(geometry.boxes.of_face(f), box) >= 0.)
          for (unsigned int p = geometry.pieces.first_of_face(f);
               p < geometry.pieces.first_of_face(f + 1); ++p)
          {
            const ConvexRing covered = shadow(cell, f, p);
            if (width(covered) > geometry.tolerance)
              open = without(open, covered, geometry.tolerance);
          }
    if (open.size() == 1 && is_same(open[0], ring))
      return open;
    return wide_ones(open);
  }

private:
  /** The box around the joint with both of its faces. */
  SpaceBox box_of(const ConvexRing &ring) const
  {
    std::vector<Point<3>> corners;
    for (const RingCorner &corner : ring)
      for (unsigned int k = 0; k < 2; ++k)
        corners.push_back(
            pair.coordinates().place(corner.at, pair.height(k, corner.at)));
    SpaceBox box(corners);
    box.extend(geometry.tolerance);
    return box;
  }

  /** What a piece of a face of a cell covers of the joint. */
  ConvexRing shadow(const unsigned int cell,
                    const unsigned int face,
                    const unsigned int piece) const
  {
    const PlaneFrame &frame = pair.coordinates();
    LiftedRing lifted;
    for (const unsigned int v : geometry.pieces.corners(piece))
    {
      const Point<3> &place = geometry.cells.vertices[v];
      const Point<2> at = frame.project(place);
      const double height = frame.height(place);
      lifted.push_back(
          {at, {{height - pair.height(0, at), pair.height(1, at) - height}}});
    }
    // A face of the two cells covers what it enters. Another cell may also fill
    // the joint: the face that it turns to one of the two may lie on that.
    const bool faces_second =
        geometry.planes[face].normal * frame.normal() > 0.;
    std::array<double, 2> margins = {{geometry.tolerance, geometry.tolerance}};
    if (cell != cells[0] && cell != cells[1])
      margins[faces_second ? 1 : 0] = -geometry.tolerance;
    for (unsigned int k = 0; k < 2; ++k)
      lifted = part_that_clears(lifted, k, margins[k]);
    ConvexRing ring;
    for (const LiftedCorner &corner : lifted)
      ring.push_back({corner.at, invalid_index});
    if (!faces_second)
      std::reverse(ring.begin(), ring.end());
    return ring;
  }

  /** Those of some parts that are wider than the joint. */
  ConvexRings wide_ones(const ConvexRings &parts) const
  {
    ConvexRings wide;
    for (const ConvexRing &part : parts)
    {
      double least = std::numeric_limits<double>::max();
      for (const RingCorner &corner : part)
        least = std::min(least, pair.gap(corner.at));
      if (width(part) >= least - geometry.tolerance)
        wide.push_back(part);
    }
    return wide;
  }

  const FaceGeometry &geometry;
  const FacePair &pair;
  std::array<unsigned int, 2> cells;
};
} // namespace

ConvexRings parts_in_sight(const FaceGeometry &geometry,
                           const FacePair &pair,
                           const ConvexRing &ring)
{
  return JointSight(geometry, pair).parts(ring);
}
} // namespace Voussoir
