// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polygons/corner_contacts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace Voussoir
{
namespace
{
using dealii::Point;
using dealii::Tensor;

/** The length of a joint over that of the shortest side around. */
constexpr double joint_over_side = 1e-6;

/** The sine of an angle that is none. */
constexpr double straight = 1e-9;

/** A corner of a cell, with the vertices before and after. */
struct Corner
{
  Corner(const CellLoops &cells, const unsigned int cell, const unsigned int i)
      : cell(cell), i(i),
        before(cells.corner(cell, i + cells.n_sides(cell) - 1)),
        after(cells.corner(cell, i + 1)),
        back(cells.vertices[before] - cells.vertex(cell, i)),
        ahead(cells.vertices[after] - cells.vertex(cell, i))
  {}

  double shortest() const { return std::min(back.norm(), ahead.norm()); }
  /** The sine of the angle by which the loop turns to the left. */
  double turn() const
  {
    return cross(ahead, back) / (back.norm() * ahead.norm());
  }

  unsigned int cell, i, before, after;
  Tensor<1, 2> back, ahead;
};

/** The points that take the place of a vertex, of the corner and of the side.
 */
struct Cut
{
  std::array<Point<2>, 2> of_corner, of_side;
  double length;
};

/** Cut off @p corner, which touches the straight @p side at @p place. */
std::optional<Cut>
cut(const Corner &corner, const Corner &side, const Point<2> &place)
{
  const double shortest = std::min(corner.shortest(), side.shortest());
  const Tensor<1, 2> along = side.ahead / side.ahead.norm();
  const Tensor<1, 2> out({along[1], -along[0]});
  // Per unit of distance from the side, how far the corner's sides go along.
  const std::array<double, 2> rise = {{corner.back * out, corner.ahead * out}};
  if (!(std::min(rise[0], rise[1]) > straight * shortest))
    return {};
  const double back = corner.back * along / rise[0],
               ahead = corner.ahead * along / rise[1];
  const double length = joint_over_side * shortest;
  const double height = length / (back - ahead);
  if (!(back > ahead) ||
      height * std::max(std::abs(back), std::abs(ahead)) > 0.1 * shortest ||
      height > 0.1 * std::min(rise[0], rise[1]))
    return {};
  return Cut{{{place + height / rise[0] * corner.back,
               place + height / rise[1] * corner.ahead}},
             {{place + height * ahead * along, place + height * back * along}},
             length};
}
} // namespace

void join_corners(CellLoops &cells)
{
  if (!cells.facing.empty())
    return; // drawn apart
  std::vector<std::vector<Corner>> at(cells.vertices.size());
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> cells_at_edge;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
    for (unsigned int i = 0; i < cells.n_sides(c); ++i)
    {
      at[cells.corner(c, i)].emplace_back(cells, c, i);
      ++cells_at_edge[std::minmax(cells.corner(c, i), cells.corner(c, i + 1))];
    }

  // The vertices that take the place of a corner, by its cell and number.
  std::map<std::pair<unsigned int, unsigned int>, std::array<unsigned int, 2>>
      instead;
  std::vector<std::array<std::pair<unsigned int, unsigned int>, 2>> joints;
  for (unsigned int v = 0; v < at.size(); ++v)
  {
    // Others at the same point would need the same piece of the side.
    if (at[v].size() != 2)
      continue;
    const bool first_is_side =
        std::abs(at[v][0].turn()) < std::abs(at[v][1].turn());
    const Corner &side = at[v][first_is_side ? 0 : 1];
    const Corner &corner = at[v][first_is_side ? 1 : 0];
    const auto is_free = [&](const Corner &of) {
      return cells_at_edge[std::minmax(v, of.before)] == 1 &&
             cells_at_edge[std::minmax(v, of.after)] == 1;
    };
    // What was matched may lie beside the side by the tolerance.
    const double bent = straight + 2. * cells.tolerance / side.shortest();
    if (std::abs(side.turn()) > bent || corner.turn() <= bent ||
        side.cell == corner.cell || !is_free(side) || !is_free(corner))
      continue;
    const auto found = cut(corner, side, cells.vertices[v]);
    if (!found)
      continue;
    joints.push_back({{{corner.cell, corner.i}, {side.cell, side.i}}});
    for (const auto &[of, points] :
         {std::pair(corner, found->of_corner), std::pair(side, found->of_side)})
    {
      const unsigned int n = cells.vertices.size();
      instead[{of.cell, of.i}] = {{n, n + 1}};
      cells.vertices.insert(cells.vertices.end(), points.begin(), points.end());
    }
    cells.notices.push_back(
        text("Cell ", corner.cell, " touches cell ", side.cell, " at ",
             text_of_point(cells.vertices[v]),
             " with a corner only. It gets a joint of length ", found->length,
             " there; 'Rotations = false' leaves it open."));
  }
  if (joints.empty())
    return;

  const CellLoops old = cells;
  cells.loops.clear();
  cells.first = {0};
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> side_at;
  for (unsigned int c = 0; c < old.n_cells(); ++c)
  {
    std::vector<unsigned int> loop;
    for (unsigned int i = 0; i < old.n_sides(c); ++i)
    {
      const auto found = instead.find({c, i});
      if (found == instead.end())
      {
        loop.push_back(old.corner(c, i));
        continue;
      }
      side_at[{c, i}] = cells.loops.size() + loop.size();
      loop.insert(loop.end(), found->second.begin(), found->second.end());
    }
    cells.add(loop);
  }
  for (const auto &[corner, side] : joints)
    cells.facing.push_back({{side_at[corner], side_at[side]}});
}
} // namespace Voussoir
