// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/output/report/space/drawing_order.h>
#include <voussoir/packing/polyhedra/space_polygons.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <boost/geometry/algorithms/convex_hull.hpp>
#include <boost/geometry/geometries/multi_point.hpp>
#include <boost/geometry/geometries/ring.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::BoundingBox;
using dealii::Point;
using dealii::Tensor;

/**
 * How deep a cell may lie behind the plane that separates it from another one,
 * over its size: faces of files lie off their planes by several per cent.
 */
constexpr double depth_behind_planes = 0.05;

/**
 * The cosine between the view and a plane's normal below which the plane is
 * seen edge-on, so that what lies on its two sides does not overlap.
 */
constexpr double edge_on = 1e-9;

/** How far cells that touch in the picture overlap by rounding, over a size. */
constexpr double overlap_by_rounding = 1e-9;

/** A cell that is drawn, in the units of the view. */
struct DrawnCell
{
  /** The different vertices. */
  std::vector<Point<3>> vertices;
  /** A point of each face, and its unit normal; none without area. */
  std::vector<std::pair<Point<3>, Tensor<1, 3>>> planes;
  /** The convex hull in the picture, which is closed. */
  boost::geometry::model::ring<Point<2>> hull;
  /** Of the hull. */
  BoundingBox<2> box;
  /** Of the mean vertex. */
  double nearness = 0.;
};

DrawnCell drawn_cell(const CellFaces &cells,
                     const unsigned int cell,
                     const IsometricView &view)
{
  std::vector<unsigned int> numbers;
  DrawnCell result;
  for (unsigned int f = cells.first_face[cell]; f < cells.first_face[cell + 1];
       ++f)
  {
    numbers.insert(numbers.end(), cells.corners(f).begin(),
                   cells.corners(f).end());
    const PolygonMoments moments = moments_of_face(cells, f);
    if (moments.area() > 0.)
      result.planes.emplace_back(view.in_units(moments.centroid),
                                 moments.normal());
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  boost::geometry::model::multi_point<Point<2>> places;
  for (const unsigned int v : numbers)
  {
    result.vertices.push_back(view.in_units(cells.vertices[v]));
    places.push_back(view.place(cells.vertices[v]));
    result.nearness += view.nearness(cells.vertices[v]) / numbers.size();
  }
  boost::geometry::convex_hull(places, result.hull);
  result.box = BoundingBox<2>(result.hull);
  return result;
}

/** The distance that is none beside cells of this size. */
double rounding_of(const DrawnCell &a, const DrawnCell &b)
{
  double size = 0.;
  for (const DrawnCell *cell : {&a, &b})
    size = std::max({size, cell->box.side_length(0), cell->box.side_length(1)});
  return overlap_by_rounding * size;
}

/** True if a side of the first hull, which runs clockwise, parts the two. */
bool are_parted_by_side(const DrawnCell &a,
                        const DrawnCell &b,
                        const double rounding)
{
  for (std::size_t i = 0; i + 1 < a.hull.size(); ++i)
  {
    const Tensor<1, 2> side = a.hull[i + 1] - a.hull[i];
    const double least = -rounding * side.norm();
    if (std::all_of(b.hull.begin(), b.hull.end(), [&](const Point<2> &p) {
          return cross(side, p - a.hull[i]) >= least;
        }))
      return true;
  }
  return false;
}

/** True if a point of the picture is in both cells. */
bool overlap_in_picture(const DrawnCell &a, const DrawnCell &b)
{
  const double rounding = rounding_of(a, b);
  return !are_parted_by_side(a, b, rounding) &&
         !are_parted_by_side(b, a, rounding);
}

/** The best of the planes that may separate two cells. */
struct Separation
{
  /** How far the other cell lies outside the plane, at least. */
  double distance = std::numeric_limits<double>::lowest();
  /** The cosine between the plane's outer normal and the view. */
  double towards = 0.;
};

/** The plane of @p cell that has the other one farthest outside. */
Separation separation(const DrawnCell &cell,
                      const DrawnCell &other,
                      const IsometricView &view)
{
  Separation best;
  for (const auto &[point, normal] : cell.planes)
  {
    double distance = std::numeric_limits<double>::max();
    for (const Point<3> &p : other.vertices)
    {
      distance = std::min(distance, normal * (p - point));
      if (distance <= best.distance)
        break;
    }
    if (distance > best.distance)
      best = {distance, normal * view.towards};
  }
  return best;
}

/** 1 if @p b may hide @p a, -1 if @p a may hide @p b, 0 if it is unknown. */
int hiding(const DrawnCell &a, const DrawnCell &b, const IsometricView &view)
{
  Separation best = separation(a, b, view);
  const Separation of_b = separation(b, a, view);
  if (of_b.distance > best.distance)
    best = {of_b.distance, -of_b.towards};
  double size = std::numeric_limits<double>::max();
  for (const DrawnCell *cell : {&a, &b})
    size = std::min(
        size, std::max(cell->box.side_length(0), cell->box.side_length(1)));
  if (best.distance < -depth_behind_planes * size ||
      std::abs(best.towards) < edge_on)
    return 0;
  return best.towards > 0. ? 1 : -1;
}

/** For each cell those that may hide it. */
std::vector<std::vector<unsigned int>>
hidden_by(const std::vector<DrawnCell> &cells, const IsometricView &view)
{
  std::vector<BoundingBox<2>> boxes;
  for (const DrawnCell &cell : cells)
    boxes.push_back(cell.box);
  const auto tree = dealii::pack_rtree_of_indices(boxes);
  std::vector<std::vector<unsigned int>> before(cells.size());
  std::vector<std::size_t> found;
  for (unsigned int a = 0; a < cells.size(); ++a)
  {
    found.clear();
    tree.query(boost::geometry::index::intersects(boxes[a]),
               std::back_inserter(found));
    for (const std::size_t b : found)
      if (b > a && overlap_in_picture(cells[a], cells[b]))
        if (const int who = hiding(cells[a], cells[b], view))
        {
          if (who > 0)
            before[a].push_back(b);
          else
            before[b].push_back(a);
        }
  }
  return before;
}

/** A topological order; the farthest is next where that leaves a choice. */
std::vector<unsigned int>
order_of(const std::vector<std::vector<unsigned int>> &before,
         const std::vector<DrawnCell> &cells)
{
  using Entry = std::pair<double, unsigned int>;
  std::vector<unsigned int> n_behind(cells.size());
  for (const auto &others : before)
    for (const unsigned int b : others)
      ++n_behind[b];
  std::vector<Entry> by_nearness;
  for (unsigned int a = 0; a < cells.size(); ++a)
    by_nearness.emplace_back(cells[a].nearness, a);
  std::sort(by_nearness.begin(), by_nearness.end());

  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> next;
  for (const Entry &entry : by_nearness)
    if (n_behind[entry.second] == 0)
      next.push(entry);
  std::vector<bool> is_placed(cells.size());
  std::vector<unsigned int> order;
  for (auto farthest = by_nearness.begin(); order.size() < cells.size();)
  {
    // In a circle there is none that has nothing behind it.
    while (next.empty() && is_placed[farthest->second])
      ++farthest;
    const unsigned int a = next.empty() ? farthest->second : next.top().second;
    if (!next.empty())
      next.pop();
    if (is_placed[a])
      continue;
    is_placed[a] = true;
    order.push_back(a);
    for (const unsigned int b : before[a])
      if (--n_behind[b] == 0)
        next.emplace(cells[b].nearness, b);
  }
  return order;
}
} // namespace

std::vector<unsigned int> drawing_order(const CellFaces &cells,
                                        const std::vector<unsigned int> &drawn,
                                        const IsometricView &view)
{
  std::vector<DrawnCell> geometry;
  for (const unsigned int cell : drawn)
    geometry.push_back(drawn_cell(cells, cell, view));
  std::vector<unsigned int> order =
      order_of(hidden_by(geometry, view), geometry);
  std::transform(order.begin(), order.end(), order.begin(),
                 [&](const unsigned int k) { return drawn[k]; });
  return order;
}
} // namespace Voussoir
