// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/packing/polygons/line_work.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::Point;
using Points = std::vector<Point<2>>;
using Box = dealii::BoundingBox<2>;
using Tree = decltype(dealii::pack_rtree_of_indices(Points()));

std::vector<std::size_t> points_near(const Tree &tree,
                                     const Point<2> &a,
                                     const Point<2> &b,
                                     const double distance)
{
  Box box(std::array<Point<2>, 2>{{a, b}});
  box.extend(distance);
  std::vector<std::size_t> found;
  tree.query(boost::geometry::index::intersects(box),
             std::back_inserter(found));
  return found;
}

/**
 * For each point the first one no further away that is a vertex, maybe itself:
 * no point moves by more than the tolerance, whatever chain it is in.
 */
std::vector<std::size_t>
vertices_of(const Points &points, const Tree &tree, const double tolerance)
{
  std::vector<std::size_t> vertex(points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    vertex[p] = p;
    for (const std::size_t q :
         points_near(tree, points[p], points[p], tolerance))
      if (q < vertex[p] && vertex[q] == q &&
          points[p].distance(points[q]) <= tolerance)
        vertex[p] = q;
  }
  return vertex;
}
} // namespace

std::vector<LinePiece> pieces_of_lines(const PolygonList &polygons,
                                       const double tolerance)
{
  // Others are told of later.
  const auto is_used = [](const PolygonList::Polygon &polygon) {
    return !polygon.is_broken && polygon.is_finite();
  };
  Points points;
  for (const PolygonList::Polygon &polygon : polygons.polygons)
    if (is_used(polygon))
      points.insert(points.end(), polygon.ring.begin(), polygon.ring.end());
  const Tree tree = dealii::pack_rtree_of_indices(points);
  const std::vector<std::size_t> vertex = vertices_of(points, tree, tolerance);

  std::vector<LinePiece> pieces;
  /** Cut the side from one vertex to another, both by their numbers. */
  const auto cut = [&](const std::size_t a, const std::size_t b,
                       const unsigned int source) {
    const dealii::Tensor<1, 2> along = points[b] - points[a];
    std::vector<std::pair<double, std::size_t>> on_side = {{0., a}};
    for (const std::size_t p :
         points_near(tree, points[a], points[b], tolerance))
    {
      const dealii::Tensor<1, 2> to_p = points[p] - points[a];
      const double position = (along * to_p) / along.norm_square();
      if (vertex[p] != a && vertex[p] != b && position > 0. && position < 1. &&
          std::abs(cross(along, to_p)) <= tolerance * along.norm())
        on_side.emplace_back(position, vertex[p]);
    }
    on_side.emplace_back(1., b);
    std::sort(on_side.begin(), on_side.end());
    on_side.erase(std::unique(on_side.begin(), on_side.end(),
                              [](const auto &one, const auto &other) {
                                return one.second == other.second;
                              }),
                  on_side.end());
    for (std::size_t k = 1; k < on_side.size(); ++k)
      pieces.push_back(
          {points[on_side[k - 1].second], points[on_side[k].second], source});
  };
  std::size_t first = 0;
  for (unsigned int c = 0; c < polygons.polygons.size(); ++c)
  {
    const PolygonList::Polygon &polygon = polygons.polygons[c];
    if (!is_used(polygon))
      continue;
    const std::size_t n = polygon.ring.size();
    for (std::size_t i = 0; i < polygon.n_sides(); ++i)
      if (const std::size_t a = vertex[first + i],
          b = vertex[first + (i + 1) % n];
          a != b)
        cut(a, b, c);
    first += n;
  }
  return pieces;
}
} // namespace Voussoir
