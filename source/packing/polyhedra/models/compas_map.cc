// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/models/compas_map.h>
#include <voussoir/packing/polyhedra/models/compas_mesh.h>

#include <algorithm>

namespace Voussoir
{
using Json = nlohmann::ordered_json;

std::optional<AffineMap> compas_map(const Json *const tree)
{
  if (tree == nullptr || tree->is_null())
    return {};
  const Json *const matrix = value_of(*unwrapped(*tree).tree, "matrix");
  AffineMap map;
  bool is_valid =
      matrix != nullptr && matrix->is_array() && matrix->size() == 4;
  for (unsigned int i = 0; i < 4 && is_valid; ++i)
  {
    const Json &row = (*matrix)[i];
    is_valid = row.is_array() && row.size() == 4 &&
               std::all_of(row.begin(), row.end(),
                           [](const Json &x) { return x.is_number(); });
    for (unsigned int j = 0; j < 4 && is_valid; ++j)
    {
      const double x = row[j].get<double>();
      if (i == 3)
        is_valid = x == (j == 3 ? 1. : 0.);
      else
        (j == 3 ? map.b[i] : map.A[i][j]) = x;
    }
  }
  if (!is_valid)
    throw CompasFault("has a transformation that is no matrix of 4 by 4 "
                      "numbers with the last row 0, 0, 0, 1");
  return map;
}
} // namespace Voussoir
