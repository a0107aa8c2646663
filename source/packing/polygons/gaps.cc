// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/cell_tree.h>
#include <voussoir/packing/polygons/polygon_checks.h>
#include <voussoir/packing/polygons/side_pairs.h>

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

/** The width of a gap, over the mean size of a cell, up to which it is told of.
 */
constexpr double narrow_for_cell = 0.05;

/** The width of such a gap over the distance up to which cells touch. */
constexpr double narrow_for_touching = 10.;

/** The largest sine of the angle between sides that face each other. */
constexpr double largest_sine = 0.3;

/** The vertices of a side, counted through all cells, in ascending order. */
std::pair<unsigned int, unsigned int> ends_of(const CellLoops &cells,
                                              const unsigned int side)
{
  const unsigned int c = cells.cell_of_side(side);
  const unsigned int i = side - cells.first[c];
  return std::minmax({cells.corner(c, i), cells.corner(c, i + 1)});
}

/** The sides that no other cell has, in the order of the cells. */
std::vector<PolygonSide> open_sides(const CellLoops &cells)
{
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> n_cells;
  const auto visit_sides = [&](const auto &visit) {
    for (unsigned int c = 0; c < cells.n_cells(); ++c)
      for (unsigned int i = 0; i < cells.n_sides(c); ++i)
        visit(c, i, std::minmax({cells.corner(c, i), cells.corner(c, i + 1)}));
  };
  visit_sides(
      [&](unsigned int, unsigned int, const auto &ends) { ++n_cells[ends]; });
  for (const auto &pair : cells.facing)
    for (const unsigned int side : pair)
      n_cells[ends_of(cells, side)] = 2;
  std::vector<PolygonSide> open;
  visit_sides([&](unsigned int c, unsigned int i, const auto &ends) {
    if (n_cells[ends] == 1)
      open.emplace_back(c, cells.vertex(c, i), cells.vertex(c, i + 1));
  });
  return open;
}

/** The largest distance between two sides along a strip. */
double width_of(const SidePair &pair)
{
  return std::max(pair.gap(pair.low), pair.gap(pair.high));
}

/** True if the strip is a gap, and longer than it is wide. */
bool is_gap(const SidePair &pair, const GapLimits &limits)
{
  const double width = width_of(pair);
  return pair.length() > width && width > limits.touching &&
         width <= limits.widest && pair.least_gap() >= -limits.touching;
}

/** The strip between two sides that face each other, beside the first. */
std::optional<SidePair> strip_between(const std::vector<PolygonSide> &sides,
                                      const std::array<std::size_t, 2> &side,
                                      const GapLimits &limits)
{
  const Tensor<1, 2> &along = sides[side[0]].along,
                     &back = sides[side[1]].along;
  if (!(along * back < 0. && std::abs(cross(along, back)) <= largest_sine))
    return {};
  const SidePair pair(sides, side, along);
  if (!(pair.length() > 0.) || !is_gap(pair, limits))
    return {};
  return pair;
}
} // namespace

std::vector<Gap> find_gaps(const CellLoops &cells, const GapLimits &limits)
{
  const std::vector<PolygonSide> open = open_sides(cells);
  const SideTree tree(open, 0.);
  std::vector<SidePair> strips;
  for (std::size_t i = 0; i < open.size(); ++i)
    for (const std::size_t j : tree.near(i, limits.widest))
      if (open[i].cell < open[j].cell)
        if (const auto strip = strip_between(open, {{i, j}}, limits))
          strips.push_back(*strip);
  std::vector<Gap> gaps;
  if (strips.empty())
    return gaps;

  const std::vector<PolygonSide> sides = sides_of(cells);
  const SideTree all(sides, limits.tolerance);
  std::map<std::array<unsigned int, 2>, Gap> widest;
  for (const SidePair &strip : strips)
    for (const SidePair &part : all.uncovered(strip))
    {
      if (!is_gap(part, limits))
        continue;
      const std::vector<Point<2>> outline = part.outline();
      Gap gap{{{open[part.side[0]].cell, open[part.side[1]].cell}},
              width_of(part),
              {}};
      std::copy(outline.begin(), outline.end(), gap.outline.begin());
      const auto [entry, is_new] = widest.emplace(gap.cells, gap);
      if (!is_new && gap.width > entry->second.width)
        entry->second = gap;
    }
  for (const auto &[pair, gap] : widest)
    gaps.push_back(gap);
  return gaps;
}

GapLimits limits_of_gaps(const PolygonList &polygons,
                         const double tolerance,
                         const double joint_width)
{
  const double touching = std::max(tolerance, joint_width);
  return {touching,
          std::max(narrow_for_cell * mean_size(polygons),
                   narrow_for_touching * touching),
          tolerance};
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
      DrawingFault::Kind::floats, cell,
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

void look_around(PolygonList &polygons, const GapLimits &limits)
{
  std::vector<std::vector<Point<2>>> rings;
  for (const PolygonList::Polygon &polygon : polygons.polygons)
    rings.push_back(polygon.is_broken ? std::vector<Point<2>>() : polygon.ring);
  const CellTree cells(rings);
  for (unsigned int c = 0; c < rings.size(); ++c)
    if (!rings[c].empty())
      look_at_neighbours(polygons, cells, c, limits);
  for (const Gap &gap : find_gaps(loops_of(polygons), limits))
  {
    const unsigned int c = gap.cells[0];
    DrawingFault fault = polygons.fault(
        DrawingFault::Kind::gap, c,
        text("is ", gap.width, " apart from cell ", gap.cells[1], " (",
             polygons.record_of(gap.cells[1]), ") at ",
             text_of_point(gap.place()),
             ". Set 'Packing/polygons/Joint width' to at least that if they "
             "should touch."));
    fault.cells.push_back(gap.cells[1]);
    fault.size = gap.width;
    fault.outline.assign(gap.outline.begin(), gap.outline.end());
    polygons.faults.push_back(fault);
  }
}
} // namespace Voussoir
