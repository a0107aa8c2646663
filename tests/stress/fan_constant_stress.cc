// SPDX-License-Identifier: LGPL-2.1-or-later

// A cell under the tractions of a constant stress S has that stress in every
// sub-cell, in the paper's reconstruction and in the refined ones: regular
// polygons, parallelograms and affine hexagons, bricks with hanging nodes, long
// bricks, and the cells of a random packing.

#include <voussoir/stress/fan.h>
#include <voussoir/stress/least_norm.h>

#include "tests.h"

namespace test_fan_constant_stress
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** The largest error of stress and scaled divergence over the norm of S. */
double error_of(CellStress &cell_stress,
                const std::vector<Point<2>> &vertices,
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
  std::vector<SubCellStress> sub_cells(cell_stress.n_sub_cells());
  if (!cell_stress.solve(
          {centre, vertices, forces, std::vector<Tensor<1, 2>>(n)},
          {sub_cells.data(), sub_cells.size()}))
    return std::numeric_limits<double>::infinity();
  double error = 0.;
  for (const auto &sub_cell : sub_cells)
    error = std::max({error, (sub_cell.stress - S).norm() / S.norm(),
                      diameter * sub_cell.divergence.norm() / S.norm()});
  return error;
}

double error_of(const std::vector<Point<2>> &vertices,
                const Point<2> &centre,
                const Tensor<2, 2> &S)
{
  Fan fan(vertices.size());
  return error_of(fan, vertices, centre, S);
}

/** The error of the refined reconstruction. */
double error_of_refined(const std::vector<Point<2>> &vertices,
                        const Point<2> &centre,
                        const Tensor<2, 2> &S,
                        const unsigned int n_refinements,
                        const unsigned int degree)
{
  LeastNorm least_norm(vertices.size(), n_refinements, degree);
  return error_of(least_norm, vertices, centre, S);
}

void run()
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
  // The rounding of the forces on the long sides has a lever of the aspect, and
  // so the error grows with its square.
  for (const double aspect : {1e2, 1e4, 1e6})
  {
    std::ostringstream name;
    name << "brick of aspect " << aspect << ", error over the aspect's square";
    const std::vector<Point<2>> long_brick = {{0, 0},          {aspect / 2, 0},
                                              {aspect, 0},     {aspect, 1},
                                              {aspect / 2, 1}, {0, 1}};
    check_error(name.str(),
                error_of(long_brick, {aspect / 2, 0.5}, S) / (aspect * aspect),
                1e-15);
    const double refined =
        error_of_refined(long_brick, {aspect / 2, 0.5}, S, 0, 0);
    // Where the square is more than 1e-6, the cell is refused.
    if (aspect < 1e5)
      check_error(name.str() + ", refined", refined / (aspect * aspect), 1e-15);
    else
      check(name.str() + ", refined, is refused", std::isinf(refined));
  }
  for (const unsigned int degree : {0, 1})
    for (const unsigned int n_refinements : {0, 1, 2})
    {
      std::ostringstream name;
      name << "refined " << n_refinements << " times, degree " << degree;
      check_error(name.str() + ", triangle",
                  error_of_refined({{0, 0}, {1, 0.2}, {0.3, 1}}, {0.4, 0.4}, S,
                                   n_refinements, degree),
                  1e-12);
      check_error(name.str() + ", brick with two hanging nodes",
                  error_of_refined(brick, {1, 0.5}, S, n_refinements, degree),
                  1e-12);
    }

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

  const Packing<2> packing = random_packing(3000, 1);
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

const RoomTest test("fan_constant_stress", run);
} // namespace test_fan_constant_stress
