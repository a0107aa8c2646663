// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/cell_tree.h>

#include <deal.II/boost_adaptors/bounding_box.h>
#include <deal.II/boost_adaptors/point.h>

#include <boost/geometry.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::Point;
using Ring = std::vector<Point<2>>;

/** The distance from a point to a ring, and the point of the ring there. */
std::pair<double, Point<2>> nearest_point(const Point<2> &p, const Ring &ring)
{
  std::pair<double, Point<2>> nearest(std::numeric_limits<double>::max(), p);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const Point<2> on_side =
        nearest_on_segment(p, ring[i], ring[(i + 1) % ring.size()]);
    const double distance = p.distance(on_side);
    if (distance < nearest.first)
      nearest = {distance, on_side};
  }
  return nearest;
}

bool meet(const Ring &one, const Ring &other)
{
  using Polygon = boost::geometry::model::ring<Point<2>, false, false>;
  return boost::geometry::intersects(Polygon(one.begin(), one.end()),
                                     Polygon(other.begin(), other.end()));
}

/** The distance of two cells, and a place between them where it is least. */
std::pair<double, Point<2>> between(const Ring &one, const Ring &other)
{
  // Where they do not overlap they are nearest at a vertex of one of them.
  std::pair<double, Point<2>> nearest(std::numeric_limits<double>::max(), {});
  for (const auto &[a, b] : {std::tie(one, other), std::tie(other, one)})
    for (const Point<2> &p : a)
    {
      const auto [distance, q] = nearest_point(p, b);
      if (distance < nearest.first)
        nearest = {distance, p + 0.5 * (q - p)};
    }
  if (nearest.first > 0. && meet(one, other))
    nearest.first = 0.;
  return nearest;
}
} // namespace

std::vector<CellTree::Box> CellTree::boxes_of(const std::vector<Ring> &rings)
{
  std::vector<Box> boxes;
  for (const Ring &ring : rings)
    boxes.push_back(ring.empty() ? Box() : Box(ring));
  return boxes;
}

CellTree::CellTree(std::vector<Ring> rings_in)
    : rings(std::move(rings_in)), boxes(boxes_of(rings)),
      tree(dealii::pack_rtree_of_indices(boxes))
{}

std::optional<NearestCell>
CellTree::nearest(const unsigned int cell,
                  const std::function<bool(unsigned int)> &counts) const
{
  namespace bgi = boost::geometry::index;
  std::optional<NearestCell> found;
  const auto is_other = [&](const std::size_t c) {
    return c != cell && !rings[c].empty() && counts(c);
  };
  for (auto c = tree.qbegin(bgi::nearest(boxes[cell], unsigned(rings.size())) &&
                            bgi::satisfies(is_other));
       c != tree.qend(); ++c)
  {
    // The boxes come in the order of their distances.
    if (found &&
        boost::geometry::distance(boxes[cell], boxes[*c]) > found->distance)
      break;
    const auto [distance, place] = between(rings[cell], rings[*c]);
    if (!found || distance < found->distance)
      found = {static_cast<unsigned int>(*c), distance, place};
  }
  return found;
}
} // namespace Voussoir
