// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/base/none.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polygons/polygon_checks.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::Point;
using dealii::Tensor;
using Box = dealii::BoundingBox<2>;

/** The width of a gap, over the mean size of a cell, up to which it is narrow.
 */
constexpr double narrow_for_cell = 1e-3;

/** The same over the tolerance. */
constexpr double narrow_for_tolerance = 10.;

/** A side that no other cell has. */
struct OpenSide
{
  unsigned int cell;
  Point<2> start;
  Point<2> end;
};

/** The vertices of a side, counted through all cells, in ascending order. */
std::pair<unsigned int, unsigned int> ends_of(const CellLoops &cells,
                                              const unsigned int side)
{
  const unsigned int c =
      std::upper_bound(cells.first.begin(), cells.first.end(), side) -
      cells.first.begin() - 1;
  const unsigned int i = side - cells.first[c];
  return std::minmax({cells.corner(c, i), cells.corner(c, i + 1)});
}

/** The sides of one cell only, in the order of the cells. */
std::vector<OpenSide> open_sides(const CellLoops &cells)
{
  struct Halfedge
  {
    unsigned int cell, start, end;
  };
  std::map<std::pair<unsigned int, unsigned int>, Halfedge> by_ends;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
    for (unsigned int i = 0; i < cells.n_sides(c); ++i)
    {
      const unsigned int a = cells.corner(c, i), b = cells.corner(c, i + 1);
      const auto [entry, is_new] =
          by_ends.emplace(std::minmax({a, b}), Halfedge{c, a, b});
      if (!is_new)
        entry->second.cell = none;
    }

  for (const auto &pair : cells.facing)
    for (const unsigned int side : pair)
      by_ends.erase(ends_of(cells, side));

  std::vector<OpenSide> open;
  for (const auto &[ends, h] : by_ends)
    if (h.cell != none)
      open.push_back({h.cell, cells.vertices[h.start], cells.vertices[h.end]});
  std::stable_sort(
      open.begin(), open.end(),
      [](const OpenSide &a, const OpenSide &b) { return a.cell < b.cell; });
  return open;
}

/** The root of the mean area of a cell. */
double mean_size(const CellLoops &cells)
{
  double twice_area = 0.;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
    for (unsigned int i = 1; i + 1 < cells.n_sides(c); ++i)
      twice_area += cross(cells.vertex(c, i) - cells.vertex(c, 0),
                          cells.vertex(c, i + 1) - cells.vertex(c, 0));
  return std::sqrt(0.5 * twice_area / cells.n_cells());
}

/**
 * The width of the gap between two sides that face each other along more than
 * @p width; infinite if they do not.
 */
double
gap_between(const OpenSide &one, const OpenSide &other, const double width)
{
  const double infinite = std::numeric_limits<double>::infinity();
  const double length = one.start.distance(one.end);
  const Tensor<1, 2> along = (one.end - one.start) / length;
  const auto position = [&](const Point<2> &p) {
    return along * (p - one.start);
  };
  // Positive to the right, which is outside the cell.
  const auto distance = [&](const Point<2> &p) {
    return cross(p - one.start, along);
  };
  // The other side runs in the opposite direction.
  const double begin = position(other.end), end = position(other.start);
  const double low = std::max(0., begin), high = std::min(length, end);
  if (!(high - low > width))
    return infinite;
  const auto at = [&](const double s) {
    const double t = (s - begin) / (end - begin);
    return (1. - t) * distance(other.end) + t * distance(other.start);
  };
  const double at_low = at(low), at_high = at(high);
  return std::min(at_low, at_high) < -width ? infinite
                                            : std::max(at_low, at_high);
}
} // namespace

std::string describe_narrow_gaps(const CellLoops &cells, const double tolerance)
{
  const double width = std::max(narrow_for_cell * mean_size(cells),
                                narrow_for_tolerance * tolerance);
  const std::vector<OpenSide> sides = open_sides(cells);
  std::vector<Box> boxes;
  for (const OpenSide &side : sides)
  {
    boxes.emplace_back(std::array<Point<2>, 2>{{side.start, side.end}});
    boxes.back().extend(width);
  }
  const auto tree = dealii::pack_rtree_of_indices(boxes);

  std::map<std::pair<unsigned int, unsigned int>, Point<2>> place_of_pair;
  double widest = 0.;
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (auto j = tree.qbegin(boost::geometry::index::intersects(boxes[i]));
         j != tree.qend(); ++j)
    {
      const OpenSide &one = sides[i], &other = sides[*j];
      const double gap =
          one.cell < other.cell ? gap_between(one, other, width) : 2. * width;
      if (gap > width)
        continue;
      widest = std::max(widest, gap);
      place_of_pair.emplace(std::make_pair(one.cell, other.cell),
                            one.start + 0.5 * (one.end - one.start));
    }
  if (place_of_pair.empty())
    return "";
  const auto &[pair, place] = *place_of_pair.begin();
  const std::size_t n_others = place_of_pair.size() - 1;
  return text("Cells ", pair.first, " and ", pair.second,
              " face each other across a narrow gap near ",
              text_of_point(place), ", which carries nothing",
              n_others > 0 ? text(", as do ", n_others, " more pairs") : "",
              "; the widest such gap is ", widest,
              ". If they should touch, give more than that as 'Matching "
              "tolerance', which is now ",
              tolerance, ".");
}
} // namespace Voussoir
