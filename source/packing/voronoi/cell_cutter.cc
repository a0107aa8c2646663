// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/voronoi/cell_cutter.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

void CellCutter::cut(const unsigned int cell, std::vector<Corner> &loop)
{
  remaining.swap(loop);
  for (unsigned int side = 0; side < polygon.n_sides(); ++side)
    cut_at_side(cell, side);
  remaining.swap(loop);
  Assert(std::all_of(loop.begin(), loop.end(),
                     [](const Corner &c) { return c.vertex != invalid_index; }),
         dealii::ExcInternalError());
}

void CellCutter::cut_at_side(const unsigned int cell, const unsigned int side)
{
  const auto is_beyond = [&](const Corner &corner) {
    return polygon.beyond(corner.position, side) > 0.;
  };
  if (std::none_of(remaining.begin(), remaining.end(), is_beyond))
    return;

  result.clear();
  for (unsigned int i = 0; i < remaining.size(); ++i)
  {
    const Corner &start = remaining[i];
    const Corner &end = remaining[(i + 1) % remaining.size()];
    const bool from_outside = is_beyond(start);
    if (!from_outside)
      result.push_back(start);
    if (from_outside == is_beyond(end))
      continue;
    Corner corner = meeting_point(cell, start, end, side);
    corner.neighbour = from_outside ? start.neighbour : invalid_index;
    corner.side = from_outside ? start.side : side;
    result.push_back(corner);
  }
  remaining.swap(result);
}

/**
 * The point where the edge from @p start to @p end crosses a side, or its
 * extension.
 */
CellCutter::Corner CellCutter::meeting_point(const unsigned int cell,
                                             const Corner &start,
                                             const Corner &end,
                                             const unsigned int side)
{
  const unsigned int n = polygon.n_sides();
  Corner corner;
  if (start.neighbour != invalid_index)
    corner.vertex = crossing(cell, start.neighbour, side);
  else if (start.side != invalid_index && (start.side + 1) % n == side)
    corner.vertex = polygon_corner(side);
  else if (start.side != invalid_index && (side + 1) % n == start.side)
    corner.vertex = polygon_corner(start.side);

  if (corner.vertex != invalid_index)
    corner.position = vertices[corner.vertex - first_vertex].position;
  else // on no edge of the result: beyond another side, clear of rounding
  {
    const double from = polygon.beyond(start.position, side);
    const double to = polygon.beyond(end.position, side);
    corner.position =
        start.position + from / (from - to) * (end.position - start.position);
  }
  return corner;
}

/** The point on a side that is equidistant from two generators. */
unsigned int CellCutter::crossing(const unsigned int a,
                                  const unsigned int b,
                                  const unsigned int side)
{
  const std::array<unsigned int, 3> key = {
      {std::min(a, b), std::max(a, b), side}};
  const unsigned int next = first_vertex + vertices.size();
  const auto [entry, is_new] = crossings.insert({key, next});
  if (is_new)
  {
    // The two generators are not one above the other, as seen from the side:
    // the edge between them would be parallel to it and not cross it.
    const Point<2> &start = polygon.vertex(side);
    const Tensor<1, 2> along = polygon.vertex(side + 1) - start;
    const Tensor<1, 2> apart = generators[b] - generators[a];
    const Tensor<1, 2> to_mean =
        0.5 * ((generators[a] - start) + (generators[b] - start));
    vertices.push_back(
        {start + (apart * to_mean) / (apart * along) * along, 1});
  }
  return entry->second;
}

unsigned int CellCutter::polygon_corner(const unsigned int i)
{
  if (corners[i] == invalid_index)
  {
    corners[i] = first_vertex + vertices.size();
    vertices.push_back({polygon.vertex(i), 2});
  }
  return corners[i];
}
} // namespace Voussoir
