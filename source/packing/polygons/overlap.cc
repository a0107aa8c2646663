// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/convex_overlap.h>
#include <voussoir/packing/convex_pieces.h>
#include <voussoir/packing/polygons/polygon_checks.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <set>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::Point;
using Ring = std::vector<Point<2>>;
using Box = dealii::BoundingBox<2>;

/** The distance of vertices that are the same, over the size of a cell. */
constexpr double same_within = 1e-3;

/** True if each vertex of one is next to one of the other. */
bool are_the_same(const Ring &one, const Ring &other)
{
  if (one.size() != other.size())
    return false;
  const auto [low, high] = Box(one).get_boundary_points();
  const double next_to = same_within * low.distance(high);
  return std::all_of(one.begin(), one.end(), [&](const Point<2> &p) {
    return std::any_of(other.begin(), other.end(), [&](const Point<2> &q) {
      return p.distance(q) <= next_to;
    });
  });
}

/** One convex piece of a cell. */
struct Piece
{
  unsigned int cell;
  Ring ring;
};

/** The pieces of a cell, in a list that is sorted by cells. */
auto pieces_of(const std::vector<Piece> &pieces, const unsigned int cell)
{
  const auto first = std::partition_point(
      pieces.begin(), pieces.end(),
      [cell](const Piece &piece) { return piece.cell < cell; });
  return std::make_pair(
      first, std::find_if(first, pieces.end(), [cell](const Piece &piece) {
        return piece.cell != cell;
      }));
}

/** The area that two cells have in common, of all their pieces; L^2. */
double common_area(const std::vector<Piece> &pieces,
                   const unsigned int one,
                   const unsigned int other)
{
  double area = 0.;
  const auto [first_a, end_a] = pieces_of(pieces, one);
  const auto [first_b, end_b] = pieces_of(pieces, other);
  for (auto a = first_a; a != end_a; ++a)
    for (auto b = first_b; b != end_b; ++b)
      if (overlap_depth(a->ring, b->ring, 0.) > 0.)
        area += signed_area(common_part(a->ring, b->ring));
  return area;
}

/** Throw the fault of two pieces, if they overlap. */
void check_overlap(const PolygonList &polygons,
                   const std::vector<Piece> &pieces,
                   const Piece &a,
                   const Piece &b,
                   const double tolerance)
{
  const double overlap = overlap_depth(a.ring, b.ring, tolerance);
  if (!(overlap > tolerance))
    return;
  const PolygonList::Polygon &one = polygons.polygons[a.cell];
  const PolygonList::Polygon &other = polygons.polygons[b.cell];
  const Ring common = common_part(a.ring, b.ring);
  Point<2> sum;
  for (const Point<2> &p : common)
    sum += p;
  const std::string place =
      text("cell ", a.cell, " (", polygons.record_of(a.cell), ") at ",
           text_of_point(sum / static_cast<double>(common.size())));
  const bool same = are_the_same(one.ring, other.ring);
  DrawingFault fault = polygons.fault(
      same ? DrawingFault::Kind::duplicate : DrawingFault::Kind::overlap,
      b.cell,
      same ? "is the same as " + place + "; delete one of them."
           : text("overlaps ", place, " by ", overlap, " on an area of ",
                  common_area(pieces, a.cell, b.cell),
                  ", more than the matching tolerance ", tolerance,
                  "; redraw one of them, or delete it if it is there twice."));
  fault.cells.push_back(a.cell);
  fault.size = overlap;
  fault.outline = common;
  throw fault;
}
} // namespace

void check_overlaps(PolygonList &polygons, const double tolerance)
{
  std::vector<Piece> pieces;
  std::vector<Box> boxes;
  for (unsigned int c = 0; c < polygons.polygons.size(); ++c)
    if (!polygons.polygons[c].is_broken)
      for (const auto &numbers : convex_pieces(polygons.polygons[c].ring))
      {
        Ring ring;
        for (const unsigned int v : numbers)
          ring.push_back(polygons.polygons[c].ring[v]);
        pieces.push_back({c, ring});
        boxes.emplace_back(ring);
      }

  const auto tree = dealii::pack_rtree_of_indices(boxes);
  std::vector<std::size_t> near;
  std::set<std::pair<unsigned int, unsigned int>> found;
  for (std::size_t b = 0; b < pieces.size(); ++b)
  {
    near.clear();
    tree.query(boost::geometry::index::intersects(boxes[b]),
               std::back_inserter(near));
    std::sort(near.begin(), near.end()); // so that messages do not depend on it
    for (const std::size_t a : near)
    {
      const auto pair = std::make_pair(pieces[a].cell, pieces[b].cell);
      if (a < b && pair.first != pair.second && found.count(pair) == 0 &&
          !polygons.passes([&] {
            check_overlap(polygons, pieces, pieces[a], pieces[b], tolerance);
          }))
        found.insert(pair);
    }
  }
}
} // namespace Voussoir
