// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/none.h>
#include <voussoir/base/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/generators/honeycomb.h>

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
  add_choice<Orientation>(
      prm, "Orientation", orientation,
      {{Orientation::pointed_top, "pointed top",
        "two sides are vertical; every second row is shifted to the right."},
       {Orientation::flat_top, "flat top",
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

  // The vertices have whole coordinates (i, j) in units of half a cell along a
  // line of hexagons, and of a quarter of their largest diameter across it, so
  // that shared vertices are recognised exactly. Flat tops are the mirror image
  // of pointed tops in the diagonal.
  const bool pointed = orientation == Orientation::pointed_top;
  const unsigned int n_lines = pointed ? n_rows : n_columns;
  const unsigned int n_in_line = pointed ? n_columns : n_rows;
  const double unit_along = cell_size / 2.;
  const double unit_across = cell_size / (2. * std::sqrt(3.));
  // Counterclockwise from the lowest vertex, and the same for the mirror image.
  using Offset = std::array<int, 2>;
  const std::array<Offset, 6> corners =
      pointed ? std::array<Offset, 6>{{{{0, -2}},
                                       {{1, -1}},
                                       {{1, 1}},
                                       {{0, 2}},
                                       {{-1, 1}},
                                       {{-1, -1}}}}
              : std::array<Offset, 6>{{{{0, -2}},
                                       {{-1, -1}},
                                       {{-1, 1}},
                                       {{0, 2}},
                                       {{1, 1}},
                                       {{1, -1}}}};

  CellLoops cells;
  const std::size_t n_along = 2 * n_in_line + 2;
  std::vector<unsigned int> vertex_at(n_along * (3 * n_lines + 2), none);
  for (unsigned int line = 0; line < n_lines; ++line)
    for (unsigned int k = 0; k < n_in_line; ++k)
    {
      for (const Offset &corner : corners)
      {
        const unsigned int i = 2 * k + 1 + line % 2 + corner[0];
        const unsigned int j = 3 * line + 2 + corner[1];
        unsigned int &vertex = vertex_at[j * n_along + i];
        if (vertex == none)
        {
          vertex = cells.vertices.size();
          const double along = i * unit_along, across = j * unit_across;
          cells.vertices.emplace_back(pointed ? along : across,
                                      pointed ? across : along);
        }
        cells.loops.push_back(vertex);
      }
      cells.first.push_back(cells.loops.size());
    }
  return cells;
}
} // namespace Voussoir
