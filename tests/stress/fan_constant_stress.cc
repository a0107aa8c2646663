// SPDX-License-Identifier: LGPL-2.1-or-later

// A cell under the tractions of a constant stress S has that stress in every
// sub-cell: regular polygons, parallelograms and affine hexagons, bricks with
// hanging nodes, long bricks, and the cells of a random packing.

#include <voussoir/stress/fan.h>

#include "tests.h"

using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** The largest error of stress and scaled divergence over the norm of S. */
double error_of(const std::vector<Point<2>> &vertices,
                const Point<2> &centre,
                const Tensor<2, 2> &S)
{
  const unsigned int n = vertices.size();
  std::vector<Tensor<1, 2>> forces;
  double diameter = 0.;
  for (unsigned int i = 0; i < n; ++i)
  {
    const Tensor<1, 2> edge = vertices[(i + 1) % n] - vertices[i];
    forces.push_back(S * Tensor<1, 2>({edge[1], -edge[0]}));
    diameter = std::max(diameter, vertices[i].distance(vertices[0]));
  }
  std::vector<Fan::SubCell> sub_cells(n);
  Fan fan(n);
  if (!fan.solve(centre, vertices, forces, std::vector<dealii::Tensor<1, 2>>(n),
                 dealii::ArrayView<Fan::SubCell>(sub_cells.data(), n)))
    return std::numeric_limits<double>::infinity();
  double error = 0.;
  for (const auto &sub_cell : sub_cells)
    error = std::max({error, (sub_cell.stress - S).norm() / S.norm(),
                      diameter * sub_cell.divergence.norm() / S.norm()});
  return error;
}

int main()
{
  const auto S = tensor(-1, 0.7, 0.7, 2);
  for (unsigned int n = 3; n <= 12; ++n)
  {
    std::vector<Point<2>> regular, sheared;
    for (unsigned int i = 0; i < n; ++i)
    {
      const double angle = 2. * dealii::numbers::PI * i / n;
      regular.emplace_back(std::cos(angle), std::sin(angle));
      sheared.emplace_back(3. + 2. * std::cos(angle) + std::sin(angle),
                           0.1 * std::sin(angle));
    }
    check_error("regular, n = " + std::to_string(n),
                error_of(regular, {0, 0}, S), 1e-12);
    check_error("sheared, n = " + std::to_string(n),
                error_of(sheared, {3, 0}, S), 1e-11);
  }
  check_error(
      "100 sides",
      [&] {
        std::vector<Point<2>> regular;
        for (unsigned int i = 0; i < 100; ++i)
          regular.emplace_back(std::cos(i * dealii::numbers::PI / 50),
                               std::sin(i * dealii::numbers::PI / 50));
        return error_of(regular, {0, 0}, S);
      }(),
      1e-10);

  const std::vector<Point<2>> brick = {{0, 0}, {1, 0}, {2, 0},
                                       {2, 1}, {1, 1}, {0, 1}};
  check_error("brick with two hanging nodes", error_of(brick, {1, 0.5}, S),
              1e-12);
  check_error(
      "brick of 1e-9",
      [&] {
        std::vector<Point<2>> small = brick;
        for (Point<2> &p : small)
          p *= 1e-9;
        return error_of(small, {1e-9, 0.5e-9}, S);
      }(),
      1e-12);
  check_error("brick of aspect 100",
              error_of({{0, 0}, {50, 0}, {100, 0}, {100, 1}, {50, 1}, {0, 1}},
                       {50, 0.5}, S),
              1e-9);

  // A corner cut off: the error grows as the rounding of the vertices over the
  // short side, and the cell stays determined.
  for (const double cut : {1e-2, 1e-4, 1e-6, 1e-8})
  {
    std::ostringstream name;
    name << "square with a corner cut off by " << cut;
    check_error(
        name.str(),
        cut * error_of({{0, 0}, {1, 0}, {1, 1 - cut}, {1 - cut, 1}, {0, 1}},
                       {0.5, 0.5}, S),
        1e-14);
  }

  const Packing packing = random_packing(3000, 1);
  double error = 0.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    std::vector<Point<2>> vertices;
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      vertices.push_back(packing.vertex(c, i));
    error = std::max(error, error_of(vertices, packing.centre(c), S));
  }
  check_error("3000 random cells", error, 1e-9);
}
