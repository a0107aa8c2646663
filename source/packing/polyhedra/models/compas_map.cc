// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/models/compas_map.h>
#include <voussoir/packing/polyhedra/models/compas_mesh.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
using Json = nlohmann::ordered_json;

namespace
{
/**
 * The determinant of a map over the cube of its norm below which blocks are
 * flattened beyond the digits that coordinates have.
 */
constexpr double least_relative_determinant = 1e-12;

/** The rows of 4 by 4 numbers; @throws CompasFault if it is none. */
dealii::FullMatrix<double> matrix_of(const Json *const tree)
{
  bool is_valid = tree != nullptr && tree->is_array() && tree->size() == 4;
  dealii::FullMatrix<double> matrix(4, 4);
  for (unsigned int i = 0; i < 4 && is_valid; ++i)
  {
    const Json &row = (*tree)[i];
    is_valid = row.is_array() && row.size() == 4 &&
               std::all_of(row.begin(), row.end(),
                           [](const Json &x) { return x.is_number(); });
    for (unsigned int j = 0; j < 4 && is_valid; ++j)
      matrix(i, j) = row[j].get<double>();
  }
  if (!is_valid)
    throw CompasFault(ModelDefect::Kind::bad_matrix,
                      "has a transformation that is no matrix of 4 by 4 "
                      "numbers; write four rows of four");
  return matrix;
}
} // namespace

std::optional<AffineMap> compas_map(const Json *const tree)
{
  if (tree == nullptr || tree->is_null())
    return {};
  const dealii::FullMatrix<double> matrix =
      matrix_of(value_of(*unwrapped(*tree).tree, "matrix"));
  AffineMap map;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 4; ++j)
      (j == 3 ? map.b[i] : map.A[i][j]) = matrix(i, j);
  for (unsigned int j = 0; j < 4; ++j)
    if (matrix(3, j) != (j == 3 ? 1. : 0.))
      throw CompasFault(ModelDefect::Kind::projective_map,
                        text("has a transformation with the last row ",
                             matrix(3, 0), ", ", matrix(3, 1), ", ",
                             matrix(3, 2), ", ", matrix(3, 3),
                             "; it should be 0, 0, 0, 1"));
  if (std::abs(determinant(map.A)) <=
      least_relative_determinant * std::pow(map.A.norm(), 3))
    throw CompasFault(ModelDefect::Kind::singular_map,
                      "has a transformation that maps all blocks into a "
                      "plane; its determinant should be 1, or that of a scale");
  return map;
}
} // namespace Voussoir
