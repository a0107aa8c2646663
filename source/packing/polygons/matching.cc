// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/base/invalid_index.h>
#include <voussoir/base/lowest_in_sets.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polygons/matching.h>
#include <voussoir/packing/polygons/polygon_checks.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <boost/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace Voussoir
{
namespace
{
using dealii::Point;
using Box = dealii::BoundingBox<2>;

/**
 * The number of tolerances by which a vertex may be moved: one, and one more
 * where a vertex between two others joins them. Beyond, short sides have merged
 * in a chain.
 */
constexpr double longest_move = 2.;

/**
 * The number of tolerances by which a vertex may then lie inside the chord of
 * its neighbours in a convex cell: an inserted vertex is that far from the
 * side, and one more, and so may be its neighbours on the other side of it.
 */
constexpr double deepest_dent = 2. * (longest_move + 1.);

/**
 * The largest move of a vertex or side, over the mean size of a cell, that a
 * block may be said to keep its shape with.
 */
constexpr double largest_relative_move = 1e-3;

/** A point near a side, at @p position along it, from 0 to 1. */
struct Contact
{
  unsigned int vertex;
  double distance;
  unsigned int side;
  double position;
};

/** The box around two points, wider by @p margin on all sides. */
Box box_around(const Point<2> &a, const Point<2> &b, const double margin)
{
  Box box(std::array<Point<2>, 2>{{a, b}});
  box.extend(margin);
  return box;
}

/** Matches one list; one object, used once. */
class PolygonMatcher
{
public:
  PolygonMatcher(PolygonList &polygons, const double tolerance)
      : polygons(polygons), tolerance(tolerance), corners(loops_of(polygons)),
        points(corners.vertices), tree(dealii::pack_rtree_of_indices(points))
  {}

  CellLoops match()
  {
    find_vertices();
    CellLoops cells;
    std::vector<unsigned int> number(points.size(), invalid_index);
    for (unsigned int c = 0; c < polygons.polygons.size(); ++c)
    {
      std::vector<unsigned int> vertices = loop(c);
      polygons.passes([&] { check_loop(c, vertices); });
      for (unsigned int &v : vertices)
      {
        if (number[v] == invalid_index)
        {
          number[v] = cells.vertices.size();
          cells.vertices.push_back(points[v]);
        }
        v = number[v];
      }
      cells.add(vertices);
    }
    polygons.refuse_faults();
    cells.tolerance = deepest_dent * tolerance;
    judge_moves(cells);
    return cells;
  }

private:
  using Tree = decltype(dealii::pack_rtree_of_indices(
      std::declval<std::vector<Point<2>>>()));

  void find_vertices()
  {
    const unsigned int n = points.size();
    boost::disjoint_sets_with_storage<> sets(n);
    std::vector<std::size_t> near;
    for (unsigned int p = 0; p < n; ++p)
    {
      near.clear();
      tree.query(boost::geometry::index::intersects(
                     box_around(points[p], points[p], tolerance)),
                 std::back_inserter(near));
      for (const std::size_t q : near)
        if (q < p && points[p].distance(points[q]) <= tolerance)
          sets.union_set(std::size_t(p), q);
    }
    vertex = lowest_in_sets(sets, n);
  }

  /** The vertices to insert into a cell, each once, in order along its loop. */
  std::vector<Contact> contacts(const unsigned int cell) const
  {
    std::vector<Contact> found;
    for (unsigned int side = 0; side < corners.n_sides(cell); ++side)
      find_contacts_of_side(cell, side, found);

    // A vertex near a sharp corner is near two sides; it belongs to the nearer.
    std::sort(found.begin(), found.end(), [](const auto &a, const auto &b) {
      return std::tie(a.vertex, a.distance, a.side, a.position) <
             std::tie(b.vertex, b.distance, b.side, b.position);
    });
    found.erase(std::unique(found.begin(), found.end(),
                            [](const auto &a, const auto &b) {
                              return a.vertex == b.vertex;
                            }),
                found.end());
    std::sort(found.begin(), found.end(), [](const auto &a, const auto &b) {
      return std::tie(a.side, a.position, a.vertex) <
             std::tie(b.side, b.position, b.vertex);
    });
    return found;
  }

  void find_contacts_of_side(const unsigned int cell,
                             const unsigned int side,
                             std::vector<Contact> &found) const
  {
    const unsigned int a = corners.corner(cell, side),
                       b = corners.corner(cell, side + 1);
    const dealii::Tensor<1, 2> along = points[b] - points[a];
    const double length = along.norm();
    const auto visit = [&](const std::size_t p) {
      if (vertex[p] == vertex[a] || vertex[p] == vertex[b])
        return;
      const dealii::Tensor<1, 2> to_p = points[p] - points[a];
      const double position = (along * to_p) / (length * length);
      const double distance = std::abs(cross(along, to_p)) / length;
      if (position > 0. && position < 1. && distance <= tolerance)
        found.push_back({vertex[p], distance, side, position});
    };
    tree.query(boost::geometry::index::intersects(
                   box_around(points[a], points[b], tolerance)),
               boost::make_function_output_iterator(visit));
  }

  std::vector<unsigned int> loop(const unsigned int cell) const
  {
    std::vector<unsigned int> result;
    const std::vector<Contact> inserted = contacts(cell);
    auto next = inserted.begin();
    for (unsigned int i = 0; i < corners.n_sides(cell); ++i)
    {
      const unsigned int v = vertex[corners.corner(cell, i)];
      if (result.empty() || v != result.back())
        result.push_back(v);
      for (; next != inserted.end() && next->side == i; ++next)
        result.push_back(next->vertex);
    }
    while (result.size() > 1 && result.back() == result.front())
      result.pop_back();
    return result;
  }

  void check_loop(const unsigned int cell, std::vector<unsigned int> loop) const
  {
    const std::string advice =
        text("within the matching tolerance ", tolerance,
             "; lower the tolerance or redraw the cell.");
    for (unsigned int i = 0; i < corners.n_sides(cell); ++i)
    {
      const unsigned int p = corners.corner(cell, i);
      if (points[p].distance(points[vertex[p]]) > longest_move * tolerance)
        polygons.refuse(DrawingFault::Kind::too_small_to_match, cell,
                        "has a chain of short sides at " +
                            text_of_point(points[p]) + ", each " + advice);
    }
    if (loop.size() < 3)
      polygons.refuse(DrawingFault::Kind::too_small_to_match, cell,
                      "at " + text_of_point(points[corners.corner(cell, 0)]) +
                          " has fewer than three vertices left of which "
                          "no two are " +
                          advice);
    std::sort(loop.begin(), loop.end());
    const auto twice = std::adjacent_find(loop.begin(), loop.end());
    if (twice != loop.end())
      polygons.refuse(DrawingFault::Kind::too_small_to_match, cell,
                      "touches itself at " + text_of_point(points[*twice]) +
                          " " + advice);
  }

  /** Refuse moves that change blocks, and tell of those that may matter. */
  void judge_moves(CellLoops &cells) const
  {
    const double rounding = automatic_tolerance(polygons);
    if (tolerance <= rounding)
      return;
    const double size = mean_size(polygons);
    Move largest;
    for (unsigned int c = 0; c < corners.n_cells(); ++c)
      largest = std::max(largest, largest_move(c));
    if (largest.distance > largest_relative_move * size)
      polygons.refuse(
          DrawingFault::Kind::too_small_to_match, largest.cell,
          text("would be changed at ", text_of_point(largest.place), " by ",
               largest.distance,
               " in matching, more than a thousandth of the "
               "mean size ",
               size,
               " of a cell. Lower 'Packing/polygons/Matching tolerance', which "
               "is for what a drawing was rounded to, and set 'Joint width' "
               "beside it to the width of the widest joint: then blocks keep "
               "their shapes."));
    if (largest.distance > rounding)
      cells.notices.push_back(
          text("Matching moved vertices or sides of cells by up to ",
               largest.distance, ", ", largest.distance / size,
               " of the mean size of a cell, at ", text_of_point(largest.place),
               ". To leave the cells as they are drawn, set 'Joint width' "
               "instead."));
  }

  /** A vertex, or a point of a side, that matching moves. */
  struct Move
  {
    double distance = 0.;
    unsigned int cell = 0;
    Point<2> place;
    bool operator<(const Move &other) const
    {
      return distance < other.distance;
    }
  };

  Move largest_move(const unsigned int cell) const
  {
    Move largest;
    for (unsigned int i = 0; i < corners.n_sides(cell); ++i)
    {
      const unsigned int p = corners.corner(cell, i);
      largest = std::max(largest, Move{points[p].distance(points[vertex[p]]),
                                       cell, points[p]});
    }
    for (const Contact &contact : contacts(cell))
      largest = std::max(largest,
                         Move{contact.distance, cell, points[contact.vertex]});
    return largest;
  }

  PolygonList &polygons;
  const double tolerance;

  const CellLoops corners;
  const std::vector<Point<2>> &points;
  const Tree tree;
  /** For each point the first one that is the same vertex. */
  std::vector<unsigned int> vertex;
};
} // namespace

CellLoops match_polygons(PolygonList &polygons, const double tolerance)
{
  return PolygonMatcher(polygons, tolerance).match();
}
} // namespace Voussoir
