// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/cell_range.h>

#include <cmath>
#include <numeric>

namespace Voussoir
{
CellLoops cut_free(const Packing<2> &packing, const CellRange &cells)
{
  CellLoops result;
  // They have been checked: none is to be listed as not convex again.
  result.tolerance = std::sqrt(packing.area());
  const auto &names = packing.group_names();
  result.group_names.assign(names.begin(), names.end() - 1); // no ground
  for (unsigned int c = cells.begin; c < cells.end; ++c)
  {
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      result.vertices.push_back(packing.vertex(c, i));
    result.first.push_back(result.vertices.size());
    result.centres.push_back(packing.centre(c));
    result.group.push_back(packing.group(c));
  }
  result.loops.resize(result.vertices.size());
  std::iota(result.loops.begin(), result.loops.end(), 0);
  return result;
}
} // namespace Voussoir
