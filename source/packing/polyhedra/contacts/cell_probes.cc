// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/contacts/cell_probes.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
namespace
{
using dealii::Point;
using dealii::Tensor;

/** The winding number beyond which a place is inside, halfway between both. */
constexpr double winding_inside = 0.5;

/** The solid angle of a triangle from the origin, by Van Oosterom and Strackee.
 */
double
solid_angle(const Tensor<1, 3> &a, const Tensor<1, 3> &b, const Tensor<1, 3> &c)
{
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2. *
         std::atan2(a * cross_product_3d(b, c),
                    la * lb * lc + (a * b) * lc + (b * c) * la + (c * a) * lb);
}

/** The distance of a place from a segment. */
double distance_from_segment(const Point<3> &place,
                             const Point<3> &a,
                             const Point<3> &b)
{
  const Tensor<1, 3> side = b - a;
  const double square = side.norm_square();
  const double t =
      square > 0. ? std::clamp((place - a) * side / square, 0., 1.) : 0.;
  return place.distance(a + t * side);
}

/** The box around a segment. */
SpaceBox box_around_segment(const std::array<Point<3>, 2> &ends)
{
  return SpaceBox(ends);
}

/** How far a place beside a piece is inside of all of its sides; a length. */
double inside_of_sides(const CellFaces &cells,
                       const dealii::ArrayView<const unsigned int> &corners,
                       const Tensor<1, 3> &normal,
                       const Point<3> &place)
{
  double least = std::numeric_limits<double>::max();
  for (unsigned int i = 0; i < corners.size(); ++i)
  {
    const Point<3> &a = cells.vertices[corners[i]];
    const Tensor<1, 3> side =
        cells.vertices[corners[(i + 1) % corners.size()]] - a;
    const double length = side.norm();
    if (length > 0.)
      least =
          std::min(least, normal * cross_product_3d(side, place - a) / length);
  }
  return least;
}
} // namespace

std::array<unsigned int, 2> CellProbes::pieces_of(const unsigned int cell) const
{
  return {{geometry.pieces.first_of_face(geometry.cells.first_face[cell]),
           geometry.pieces.first_of_face(geometry.cells.first_face[cell + 1])}};
}

double CellProbes::winding_number(const unsigned int cell,
                                  const Point<3> &place) const
{
  // By the pieces of faces, so that a place in the plane of a notched face is
  // not in two triangles of which one has to cancel the other.
  const std::vector<Point<3>> &vertices = geometry.cells.vertices;
  const auto [begin, end] = pieces_of(cell);
  double angle = 0.;
  for (unsigned int p = begin; p < end; ++p)
  {
    const auto corners = geometry.pieces.corners(p);
    const Tensor<1, 3> first = vertices[corners[0]] - place;
    for (unsigned int i = 1; i + 1 < corners.size(); ++i)
      angle += solid_angle(first, vertices[corners[i]] - place,
                           vertices[corners[i + 1]] - place);
  }
  return angle / (4. * dealii::numbers::PI);
}

double CellProbes::distance_from_piece(const unsigned int face,
                                       const unsigned int piece,
                                       const Point<3> &place) const
{
  const auto corners = geometry.pieces.corners(piece);
  const FacePlane &plane = geometry.planes[face];
  if (inside_of_sides(geometry.cells, corners, plane.normal, place) >= 0.)
    return std::abs(plane.normal * (place - plane.centre));
  double least = std::numeric_limits<double>::max();
  for (unsigned int i = 0; i < corners.size(); ++i)
    least = std::min(
        least, distance_from_segment(
                   place, geometry.cells.vertices[corners[i]],
                   geometry.cells.vertices[corners[(i + 1) % corners.size()]]));
  return least;
}

double CellProbes::distance(const unsigned int cell,
                            const Point<3> &place) const
{
  double least = std::numeric_limits<double>::max();
  for (unsigned int f = geometry.cells.first_face[cell];
       f < geometry.cells.first_face[cell + 1]; ++f)
    for (unsigned int p = geometry.pieces.first_of_face(f);
         p < geometry.pieces.first_of_face(f + 1); ++p)
      least = std::min(least, distance_from_piece(f, p, place));
  return least;
}

std::vector<double> CellProbes::crossings(const unsigned int cell,
                                          const Segment &segment) const
{
  std::vector<double> found;
  for (unsigned int f = geometry.cells.first_face[cell];
       f < geometry.cells.first_face[cell + 1]; ++f)
  {
    const FacePlane &plane = geometry.planes[f];
    const double start = plane.normal * (segment[0] - plane.centre);
    const double end = plane.normal * (segment[1] - plane.centre);
    if (!((start < 0. && end > 0.) || (start > 0. && end < 0.)))
      continue;
    const double t = start / (start - end);
    const Point<3> place = segment[0] + t * (segment[1] - segment[0]);
    for (unsigned int p = geometry.pieces.first_of_face(f);
         p < geometry.pieces.first_of_face(f + 1); ++p)
      if (inside_of_sides(geometry.cells, geometry.pieces.corners(p),
                          plane.normal, place) >= -geometry.tolerance)
        found.push_back(t);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<CellProbes::Segment>
CellProbes::segments_of(const unsigned int cell) const
{
  const CellFaces &cells = geometry.cells;
  std::vector<Segment> segments;
  const SpaceBox &box = geometry.boxes.of_cell(cell);
  const auto &[low, high] = box.get_boundary_points();
  const double beyond = low.distance(high) + geometry.tolerance;
  for (unsigned int f = cells.first_face[cell]; f < cells.first_face[cell + 1];
       ++f)
  {
    for (unsigned int i = 0; i < cells.n_corners(f); ++i)
      segments.push_back({{cells.vertex(f, i), cells.vertex(f, i + 1)}});
    for (unsigned int p = geometry.pieces.first_of_face(f);
         p < geometry.pieces.first_of_face(f + 1); ++p)
    {
      const auto corners = geometry.pieces.corners(p);
      const Point<3> &origin = cells.vertices[corners[0]];
      Tensor<1, 3> sum;
      for (const unsigned int v : corners)
        sum += cells.vertices[v] - origin;
      // From just inside, to the face on the other side of the cell.
      const Tensor<1, 3> &normal = geometry.planes[f].normal;
      const Point<3> start = origin + sum / double(corners.size()) -
                             2. * geometry.tolerance * normal;
      const std::vector<double> hits =
          crossings(cell, {{start, start - beyond * normal}});
      if (!hits.empty())
        segments.push_back({{start, start - hits.front() * beyond * normal}});
    }
  }
  return segments;
}

InnerPoint CellProbes::deepest(const unsigned int one,
                               const unsigned int other) const
{
  InnerPoint deepest;
  const auto look_at = [&](const Point<3> &place) {
    const double depth = distance(other, place);
    if (depth > deepest.depth &&
        std::abs(winding_number(other, place)) > winding_inside)
      deepest = {depth, place};
  };
  const SpaceBox &box = geometry.boxes.of_cell(other);
  for (const Segment &segment : segments_of(one))
  {
    if (common_extent(box_around_segment(segment), box) < 0.)
      continue;
    std::vector<double> ends = crossings(other, segment);
    ends.insert(ends.begin(), 0.);
    ends.push_back(1.);
    const Tensor<1, 3> along = segment[1] - segment[0];
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
      look_at(segment[0] + 0.5 * (ends[k] + ends[k + 1]) * along);
    look_at(segment[0]);
    look_at(segment[1]);
  }
  return deepest;
}
} // namespace Voussoir
