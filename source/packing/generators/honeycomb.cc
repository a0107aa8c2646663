// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/invalid_index.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/generators/honeycomb.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Voussoir
{
void HoneycombGenerator::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.add_parameter("Columns", n_columns, "Number of hexagons in a row.",
                    Integer(1, 100000));
  prm.add_parameter("Rows", n_rows, "Number of hexagons in a column.",
                    Integer(1, 100000));
  prm.add_parameter("Cell size", cell_size,
                    "Distance between opposite sides of a hexagon, and so "
                    "between the centres of neighbours; a length, positive.",
                    Double(0.));
  add_choice<bool>(
      prm, "Orientation", pointed,
      {{true, "pointed top",
        "two sides are vertical; every second row is shifted to the right."},
       {false, "flat top",
        "two sides are horizontal; every second column is shifted upwards."}},
      "How the hexagons stand.");
}

CellLoops HoneycombGenerator::generate(const std::filesystem::path &,
                                       Terminal &) const
{
  check_number_of_cells(double(n_columns) * n_rows,
                        "'Packing/honeycomb/Columns' and 'Rows'");
  if (!std::isfinite(cell_size * n_columns * n_rows) || cell_size <= 0.)
    throw InputError(text("'Packing/honeycomb/Cell size' is ", cell_size,
                          "; it must be positive and finite."));

  const unsigned int n_lines = pointed ? n_rows : n_columns;
  const unsigned int n_in_line = pointed ? n_columns : n_rows;
  // Counterclockwise from the lowest vertex, and the same for the mirror image.
  std::array<std::array<int, 2>, 6> corners = {
      {{{0, -2}}, {{1, -1}}, {{1, 1}}, {{0, 2}}, {{-1, 1}}, {{-1, -1}}}};
  if (!pointed)
    std::reverse(corners.begin() + 1, corners.end());

  // A vertex by whole numbers, so that shared ones are recognised exactly:
  // along a line of hexagons in units of half a cell, and across it of a
  // quarter of their largest diameter. Flat tops are the mirror image of
  // pointed tops in the diagonal.
  const auto place = [&](const unsigned int i, const unsigned int j) {
    const double along = i * (cell_size / 2.);
    const double across = j * (cell_size / (2. * std::sqrt(3.)));
    return pointed ? dealii::Point<2>(along, across)
                   : dealii::Point<2>(across, along);
  };
  CellLoops cells;
  const std::size_t n_along = 2 * n_in_line + 2;
  std::vector<unsigned int> vertex_at(n_along * (3 * n_lines + 2),
                                      invalid_index);
  for (unsigned int line = 0; line < n_lines; ++line)
    for (unsigned int k = 0; k < n_in_line; ++k)
    {
      std::vector<unsigned int> loop;
      for (const auto &corner : corners)
      {
        const unsigned int i = 2 * k + 1 + line % 2 + corner[0];
        const unsigned int j = 3 * line + 2 + corner[1];
        unsigned int &vertex = vertex_at[j * n_along + i];
        if (vertex == invalid_index)
        {
          vertex = cells.vertices.size();
          cells.vertices.push_back(place(i, j));
        }
        loop.push_back(vertex);
      }
      cells.add(loop);
    }
  return cells;
}
} // namespace Voussoir
