// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/random.h>
#include <voussoir/packing/generators/perturbed_grid.h>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/**
 * The largest perturbation, just below 1/sqrt(8) = 0.3535..., up to which every
 * cell is convex. In units of the spacing, three consecutive corners of a cell
 * span a right triangle with legs of length 1. Its smallest altitude, and so
 * the width of any strip that holds the three, is sqrt(1/2); hence every line
 * is half of that, 1/sqrt(8), or more from one of them. If each moves by less,
 * they never come to lie on one line, and keep turning left. A quadrilateral
 * with four left turns is convex.
 */
constexpr double largest_perturbation = 0.35;

/** A point drawn uniformly from the unit disk. */
Tensor<1, 2> point_of_disk(Random &random)
{
  Tensor<1, 2> x;
  do
    for (unsigned int d = 0; d < 2; ++d)
      x[d] = 2. * random() - 1.;
  while (x.norm_square() > 1.);
  return x;
}
} // namespace

void PerturbedGridGenerator::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.add_parameter("Columns", n_columns, "Number of cells from left to right.",
                    Integer(1, 100000));
  prm.add_parameter("Rows", n_rows, "Number of cells from bottom to top.",
                    Integer(1, 100000));
  prm.add_parameter("Width", width,
                    "Width of the rectangle; a length, positive.", Double(0.));
  prm.add_parameter("Height", height,
                    "Height of the rectangle; a length, positive.", Double(0.));
  prm.add_parameter("Perturbation", perturbation,
                    "How far vertices are moved at most, over the spacing of "
                    "the grid; up to the bound all cells are convex.",
                    Double(0., largest_perturbation));
  prm.add_parameter("Seed", seed,
                    "Seed of the movements; the same seed gives the same ones "
                    "on every machine.",
                    Integer(0));
}

std::vector<Point<2>> PerturbedGridGenerator::make_vertices() const
{
  Random random(seed);
  std::vector<Point<2>> vertices;
  for (unsigned int j = 0; j <= n_rows; ++j)
    for (unsigned int i = 0; i <= n_columns; ++i)
    {
      const bool on_left_or_right = i == 0 || i == n_columns;
      const bool on_bottom_or_top = j == 0 || j == n_rows;
      Tensor<1, 2> move;
      if (!on_left_or_right && !on_bottom_or_top)
        move = point_of_disk(random);
      else if (!on_left_or_right)
        move[0] = 2. * random() - 1.;
      else if (!on_bottom_or_top)
        move[1] = 2. * random() - 1.;
      vertices.emplace_back(width * (i + perturbation * move[0]) / n_columns,
                            height * (j + perturbation * move[1]) / n_rows);
    }
  return vertices;
}

CellLoops PerturbedGridGenerator::generate(const std::filesystem::path &,
                                           Terminal &) const
{
  check_number_of_cells(double(n_columns) * n_rows,
                        "'Packing/perturbed grid/Columns' and 'Rows'");
  check_size("grid 'Packing/perturbed grid'", width, height);
  CellLoops cells;
  cells.vertices = make_vertices();
  const unsigned int above = n_columns + 1;
  for (unsigned int j = 0; j < n_rows; ++j)
    for (unsigned int i = 0; i < n_columns; ++i)
    {
      const unsigned int v = j * above + i;
      cells.add({v, v + 1, v + above + 1, v + above});
    }
  return cells;
}
} // namespace Voussoir
