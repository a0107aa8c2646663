// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/convex_pieces.h>
#include <voussoir/packing/polyhedra/contacts/face_pieces.h>
#include <voussoir/packing/polyhedra/space_polygons.h>

#include <algorithm>
#include <array>

namespace Voussoir
{
namespace
{
using dealii::Point;
using Numbers = std::vector<unsigned int>;

/** True if no vertex lies outside a side by more than the tolerance. */
bool is_nearly_convex(const std::vector<Point<2>> &ring, const double tolerance)
{
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const Point<2> &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if (a == b)
      continue;
    const DirectedLine line(a, b);
    if (std::any_of(ring.begin(), ring.end(), [&](const Point<2> &p) {
          return line.distance(p) < -tolerance;
        }))
      return false;
  }
  return true;
}

/** True if no vertex is inside the chord of its neighbours by more than the
 * tolerance, however short its sides are. */
bool has_no_dents(const std::vector<Point<2>> &ring, const double tolerance)
{
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point<2> &a = ring[i], &b = ring[(i + 1) % n], &c = ring[(i + 2) % n];
    if (cross(b - a, c - a) < -tolerance * a.distance(c))
      return false;
  }
  return true;
}

/**
 * The corner that is first in the order of coordinates: pieces do not depend on
 * where a loop begins.
 */
std::size_t lowest_corner(const CellFaces &cells, const Numbers &corners)
{
  const auto key = [&](const unsigned int v) {
    const Point<3> &place = cells.vertices[v];
    return std::array<double, 3>{{place[0], place[1], place[2]}};
  };
  return std::min_element(corners.begin(), corners.end(),
                          [&](const unsigned int v, const unsigned int w) {
                            return key(v) < key(w);
                          }) -
         corners.begin();
}

/** The vertices of a face without those next to the one before. */
Numbers distant_corners(const CellFaces &cells,
                        const unsigned int face,
                        const double tolerance)
{
  Numbers kept;
  const auto are_near = [&](const unsigned int v, const unsigned int w) {
    return !(cells.vertices[v].distance(cells.vertices[w]) > tolerance);
  };
  for (const unsigned int v : cells.corners(face))
    if (kept.empty() || !are_near(v, kept.back()))
      kept.push_back(v);
  while (kept.size() > 1 && are_near(kept.back(), kept.front()))
    kept.pop_back();
  return kept;
}

/** The convex pieces of a part of a face that has these corners. */
std::vector<Numbers> pieces_with_corners(const CellFaces &cells,
                                         const unsigned int face,
                                         const Numbers &corners,
                                         const PlaneFrame &frame,
                                         const double tolerance)
{
  std::vector<Point<2>> ring;
  for (const unsigned int v : corners)
    ring.push_back(frame.project(cells.vertices[v]));
  if (is_nearly_convex(ring, tolerance))
    return {corners};
  if (!is_simple(ring))
    throw InputError(
        text("The sides of ", describe_face(cells, face), ", which is near ",
             text_of_point(cells.vertices[corners[0]]),
             ", cross or touch each other. Correct the order of its vertices, "
             "or cut it into faces that do not."));
  const std::size_t first = lowest_corner(cells, corners);
  std::rotate(ring.begin(), ring.begin() + first, ring.end());
  std::vector<Numbers> pieces = convex_pieces(ring);
  for (Numbers &piece : pieces)
    for (unsigned int &number : piece)
      number = corners[(first + number) % corners.size()];
  return pieces;
}

/** A polygon of vertices in the coordinates of a frame, as they are given. */
ConvexRing
ring_with_corners(const CellFaces &cells,
                  const dealii::ArrayView<const unsigned int> &corners,
                  const PlaneFrame &frame)
{
  ConvexRing ring;
  for (const unsigned int v : corners)
    ring.push_back({frame.project(cells.vertices[v]), v});
  return ring;
}
} // namespace

FacePieces::FacePieces(const CellFaces &cells,
                       const std::vector<FacePlane> &planes,
                       const double tolerance)
    : cells(cells)
{
  first_piece.reserve(cells.n_faces() + 1);
  first_corner.reserve(cells.n_faces() + 1);
  loops.reserve(cells.loops.size());
  for (unsigned int f = 0; f < cells.n_faces(); ++f)
  {
    const Numbers corners = distant_corners(cells, f, tolerance);
    if (corners.size() > 2 && planes[f].area > 0.)
    {
      const PlaneFrame frame(cells.vertices[corners[0]], planes[f].normal);
      for (const Numbers &piece :
           pieces_with_corners(cells, f, corners, frame, tolerance))
      {
        const dealii::ArrayView<const unsigned int> view(piece.data(),
                                                         piece.size());
        if (!(width(ring_with_corners(cells, view, frame)) > tolerance))
          continue;
        loops.insert(loops.end(), piece.begin(), piece.end());
        first_corner.push_back(loops.size());
      }
    }
    first_piece.push_back(size());
  }
}

ConvexRing FacePieces::ring(const unsigned int piece,
                            const PlaneFrame &frame,
                            const bool is_seen_from_inside) const
{
  ConvexRing ring = ring_with_corners(cells, corners(piece), frame);
  if (is_seen_from_inside)
    std::reverse(ring.begin(), ring.end());
  return ring;
}

std::vector<Numbers> convex_pieces_of_face(const CellFaces &cells,
                                           const unsigned int face,
                                           const double tolerance)
{
  const auto view = cells.corners(face);
  const Numbers corners(view.begin(), view.end());
  const PolygonMoments moments = moments_of_face(cells, face);
  if (!(moments.area() > 0.))
    return {corners};
  const PlaneFrame frame(cells.vertices[corners[0]], moments.normal());
  std::vector<Point<2>> ring;
  for (const unsigned int v : corners)
    ring.push_back(frame.project(cells.vertices[v]));
  if (has_no_dents(ring, tolerance))
    return {corners};
  return pieces_with_corners(cells, face, corners, frame, tolerance);
}
} // namespace Voussoir
