// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/fixed_cells.h>

#include <algorithm>
#include <numeric>

namespace Voussoir
{
namespace
{
/** The elements of @p values in another order; none if there are none. */
template <typename Value>
std::vector<Value> in_order(const std::vector<Value> &values,
                            const std::vector<unsigned int> &order)
{
  std::vector<Value> ordered;
  if (!values.empty())
    for (const unsigned int k : order)
      ordered.push_back(values[k]);
  return ordered;
}
} // namespace

CellFaces with_fixed_cells(const CellFaces &cells,
                           const std::vector<bool> &is_fixed)
{
  const unsigned int n_moving = cells.n_cells() - cells.n_fixed;
  std::vector<unsigned int> order(cells.n_cells());
  std::iota(order.begin(), order.end(), 0);
  const auto moves = [&](const unsigned int c) { return !is_fixed[c]; };
  const auto first_fixed =
      std::stable_partition(order.begin(), order.begin() + n_moving, moves);

  CellFaces result;
  static_cast<CellRecords &>(result) = cells;
  result.group_names.pop_back(); // that of the ground
  result.group = in_order(cells.group, order);
  result.records = in_order(cells.records, order);
  result.centres = in_order(cells.centres, order);
  result.vertices = cells.vertices;
  result.tolerance = cells.tolerance;
  result.joint_width = cells.joint_width;
  result.joins_edges = cells.joins_edges;
  result.n_fixed = order.end() - first_fixed;
  std::vector<unsigned int> new_face(cells.n_faces());
  for (const unsigned int c : order)
  {
    for (unsigned int f = cells.first_face[c]; f < cells.first_face[c + 1]; ++f)
    {
      new_face[f] = result.n_faces();
      result.add_face(cells.corners(f));
    }
    result.end_cell();
  }
  for (const auto &[one, other] : cells.shared)
    result.shared.push_back({{new_face[one], new_face[other]}});
  return result;
}
} // namespace Voussoir
