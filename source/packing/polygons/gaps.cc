// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/base/none.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/cell_tree.h>
#include <voussoir/packing/polygons/polygon_checks.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::Point;
using dealii::Tensor;
using Box = dealii::BoundingBox<2>;

/** The width of a gap, over the mean size of a cell, up to which it is told of.
 */
constexpr double narrow_for_cell = 0.05;

/** The same over the distance up to which cells touch. */
constexpr double narrow_for_touching = 10.;

/** The largest sine of the angle between sides that face each other. */
constexpr double largest_sine = 0.3;

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

/** The gap between two sides that face each other, along more than its width.
 */
std::optional<Gap>
gap_between(const OpenSide &one, const OpenSide &other, const GapLimits &limits)
{
  const double length = one.start.distance(one.end);
  const Tensor<1, 2> along = (one.end - one.start) / length;
  const Tensor<1, 2> back = other.start - other.end;
  if (!(along * back > 0. &&
        std::abs(cross(along, back)) <= largest_sine * back.norm()))
    return {};
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
  const auto at = [&](const double s) {
    return other.end + (s - begin) / (end - begin) * back;
  };
  const double at_low = distance(at(low)), at_high = distance(at(high));
  const double width = std::max(at_low, at_high);
  const double least = std::min(at_low, at_high);
  if (!(high - low > width) || !(width > limits.touching) ||
      width > limits.widest || least < -limits.touching)
    return {};
  return Gap{
      {{one.cell, other.cell}},
      width,
      {{one.start + low * along, at(low), at(high), one.start + high * along}}};
}

/** The vertices of each cell. */
std::vector<std::vector<Point<2>>> rings_of(const CellLoops &cells)
{
  std::vector<std::vector<Point<2>>> rings(cells.n_cells());
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
    for (unsigned int i = 0; i < cells.n_sides(c); ++i)
      rings[c].push_back(cells.vertex(c, i));
  return rings;
}
} // namespace

std::vector<Gap> find_gaps(const CellLoops &cells, const GapLimits &limits)
{
  const std::vector<OpenSide> sides = open_sides(cells);
  std::vector<Box> boxes;
  for (const OpenSide &side : sides)
  {
    boxes.emplace_back(std::array<Point<2>, 2>{{side.start, side.end}});
    boxes.back().extend(0.5 * limits.widest);
  }
  const auto tree = dealii::pack_rtree_of_indices(boxes);

  std::map<std::array<unsigned int, 2>, Gap> widest;
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (auto j = tree.qbegin(boost::geometry::index::intersects(boxes[i]));
         j != tree.qend(); ++j)
    {
      if (!(sides[i].cell < sides[*j].cell))
        continue;
      const auto gap = gap_between(sides[i], sides[*j], limits);
      if (!gap)
        continue;
      const auto [entry, is_new] = widest.emplace(gap->cells, *gap);
      if (!is_new && gap->width > entry->second.width)
        entry->second = *gap;
    }
  std::vector<Gap> gaps;
  if (widest.empty())
    return gaps;
  const CellTree tree_of_cells(rings_of(cells));
  for (const auto &[pair, gap] : widest)
  {
    const auto is_third = [&between = pair](const unsigned int c) {
      return c != between[0] && c != between[1];
    };
    if (!tree_of_cells.is_in_cell(gap.place(), is_third))
      gaps.push_back(gap);
  }
  return gaps;
}

GapLimits limits_of_gaps(const PolygonList &polygons, const double touching)
{
  return {touching, std::max(narrow_for_cell * mean_size(polygons),
                             narrow_for_touching * touching)};
}

std::string describe_gaps(const std::vector<Gap> &gaps)
{
  if (gaps.empty())
    return "";
  const auto [narrowest, widest] = std::minmax_element(
      gaps.begin(), gaps.end(),
      [](const Gap &a, const Gap &b) { return a.width < b.width; });
  const std::size_t n_others = gaps.size() - 1;
  const auto &[a, b] = gaps.front().cells;
  const bool are_alike = n_others == 0 || narrowest->width == widest->width;
  return text("Cells ", a, " and ", b, " face each other across a gap near ",
              text_of_point(gaps.front().place()), ", which carries nothing",
              n_others > 0 ? text(", as do ", counted(n_others, "more pair"))
                           : "",
              "; ", n_others > 0 ? "these gaps are " : "it is ",
              are_alike ? "" : text(narrowest->width, " to "), widest->width,
              " wide. If they should touch, set 'Packing/polygons/Joint width' "
              "to at least ",
              widest->width, ".");
}

namespace
{
/** Add that @p cell floats, if it touches no other. */
void look_at_neighbours(PolygonList &polygons,
                        const CellTree &cells,
                        const unsigned int cell,
                        const GapLimits &limits)
{
  const auto nearest = cells.nearest(cell, [](unsigned int) { return true; });
  if (!nearest || nearest->distance <= limits.touching)
    return;
  DrawingFault fault = polygons.fault(
      DrawingFault::Kind::floats, cell, polygons.polygons[cell].record,
      text("touches no other cell; the nearest is cell ", nearest->cell, ", ",
           nearest->distance, " away at ", text_of_point(nearest->place),
           nearest->distance > limits.widest
               ? ". Move it there, unless something else supports it."
               : ". Set 'Packing/polygons/Joint width' to at least that if "
                 "they should touch."));
  fault.size = nearest->distance;
  polygons.faults.push_back(fault);
}
} // namespace

void look_around(PolygonList &polygons, const double touching)
{
  std::vector<std::vector<Point<2>>> rings;
  for (const PolygonList::Polygon &polygon : polygons.polygons)
    rings.push_back(polygon.is_broken ? std::vector<Point<2>>() : polygon.ring);
  const CellTree cells(rings);
  const GapLimits limits = limits_of_gaps(polygons, touching);
  for (unsigned int c = 0; c < rings.size(); ++c)
    if (!rings[c].empty())
      look_at_neighbours(polygons, cells, c, limits);
  for (const Gap &gap : find_gaps(loops_of(polygons), limits))
  {
    const unsigned int c = gap.cells[0];
    DrawingFault fault = polygons.fault(
        DrawingFault::Kind::gap, c, polygons.polygons[c].record,
        text("is ", gap.width, " apart from cell ", gap.cells[1], " (",
             polygons.record_name, ' ', polygons.polygons[gap.cells[1]].record,
             ") at ", text_of_point(gap.place()),
             ". Set 'Packing/polygons/Joint width' to at least that if they "
             "should touch."));
    fault.cells.push_back(gap.cells[1]);
    fault.size = gap.width;
    fault.outline.assign(gap.outline.begin(), gap.outline.end());
    polygons.faults.push_back(fault);
  }
}
} // namespace Voussoir
