// SPDX-License-Identifier: LGPL-2.1-or-later

// Cells with corners cut off by sides of 1e-5 to 1e-13 of their size: what
// remains is the cell with its corners, and under an uneven stress its field,
// up to the length of the sides; under a uniform one exactly. With the couples
// of the sides the torque of the forces remains as well. The elements
// themselves refuse a cell whose sides they cannot resolve.

#include <voussoir/base/geometry.h>
#include <voussoir/stress/fan.h>
#include <voussoir/stress/least_norm.h>
#include <voussoir/stress/short_sides.h>

#include "tests.h"

namespace test_short_sides
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** A stress without divergence and its mean on a straight side. */
Tensor<2, 2> uneven(const Point<2> &x)
{
  return tensor(2. * x[1], -x[0], -x[0], x[0] + x[1]);
}

Tensor<2, 2> even(const Point<2> &)
{
  return tensor(-1.2, 0.3, 0.3, -0.8);
}

using Stress = Tensor<2, 2> (*)(const Point<2> &);

std::vector<Tensor<1, 2>> forces_of(const Stress stress,
                                    const std::vector<Point<2>> &vertices)
{
  std::vector<Tensor<1, 2>> forces;
  for (unsigned int i = 0; i < vertices.size(); ++i)
  {
    const Tensor<1, 2> side = vertices[(i + 1) % vertices.size()] - vertices[i];
    forces.push_back(stress(vertices[i] + 0.5 * side) *
                     Tensor<1, 2>({side[1], -side[0]}));
  }
  return forces;
}

/** The couples of its tractions, which are linear along each side. */
std::vector<Tensor<1, 2>> shifts_of(const Stress stress,
                                    const std::vector<Point<2>> &vertices)
{
  std::vector<Tensor<1, 2>> shifts;
  for (unsigned int i = 0; i < vertices.size(); ++i)
  {
    const Point<2> &end = vertices[(i + 1) % vertices.size()];
    const Tensor<1, 2> side = end - vertices[i];
    shifts.push_back((stress(end) - stress(vertices[i])) *
                     Tensor<1, 2>({side[1], -side[0]}) / 6.);
  }
  return shifts;
}

/** A quadrilateral. */
const std::vector<Point<2>> with_corners = {
    {-0.55, -0.5}, {0.5, -0.47}, {0.46, 0.5}, {-0.48, 0.52}};

/** The quadrilateral with n_cut sides of length h about corners 0 and 2. */
std::vector<Point<2>> without_corners(const double h, const unsigned int n_cut)
{
  std::vector<Point<2>> vertices;
  for (unsigned int i = 0; i < 4; ++i)
  {
    const Point<2> &corner = with_corners[i];
    if (i % 2 == 1)
    {
      vertices.push_back(corner);
      continue;
    }
    const Tensor<1, 2> back = with_corners[(i + 3) % 4] - corner;
    const Tensor<1, 2> on = with_corners[(i + 1) % 4] - corner;
    // On a convex curve from the side before to the side after.
    for (unsigned int k = 0; k <= n_cut; ++k)
    {
      const double t = static_cast<double>(k) / n_cut;
      vertices.push_back(corner +
                         h * ((1. - t) * (1. - t) * back / back.norm() +
                              t * t * on / on.norm()));
    }
  }
  return vertices;
}

/** A cell under a stress, with couples or without. */
LoadedCell loaded(const Stress stress,
                  const bool with_couples,
                  const std::vector<Point<2>> &vertices)
{
  LoadedCell cell = {{},
                     vertices,
                     forces_of(stress, vertices),
                     std::vector<Tensor<1, 2>>(vertices.size())};
  if (with_couples)
    cell.shifts = shifts_of(stress, vertices);
  return cell;
}

double torque(const LoadedCell &cell)
{
  const Tensor<2, 2> moments = cell.moments();
  return moments[1][0] - moments[0][1];
}

/** The largest distance from the stress in the cell with its corners, if both
 * cells are solved. */
double distance(const Stress stress,
                const bool with_couples,
                const double h,
                const unsigned int n_cut,
                const SubTriangulation &cut,
                CellStress &cell_stress)
{
  const unsigned int n_per_side = cut.of_triangle().size();
  std::vector<SubCellStress> wanted(4 * n_per_side), rest(4 * n_per_side);
  const bool is_solved_with_corners =
      cell_stress.solve(loaded(stress, with_couples, with_corners),
                        {wanted.data(), wanted.size()});
  const std::vector<Point<2>> vertices = without_corners(h, n_cut);
  ShortSides short_sides(cut, 1e-4);
  if (!is_solved_with_corners ||
      !short_sides.leave_out(loaded(stress, with_couples, vertices)) ||
      short_sides.rest().vertices.size() != 4 ||
      !cell_stress.solve(short_sides.rest(), {rest.data(), rest.size()}))
    return HUGE_VAL;
  std::vector<SubCellStress> all(vertices.size() * n_per_side);
  short_sides.fill(rest, {all.data(), all.size()});

  double largest = 0.;
  for (unsigned int i = 0, side = 0; i < vertices.size(); ++i)
  {
    const bool is_short =
        vertices[i].distance(vertices[(i + 1) % vertices.size()]) < 0.1;
    for (unsigned int k = 0; k < n_per_side; ++k)
    {
      // On a spoke the nearest sub-cells of its two sides.
      const Tensor<2, 2> &found = all[i * n_per_side + k].stress;
      double error = (found - wanted[side * n_per_side + k].stress).norm();
      if (is_short)
      {
        error = HUGE_VAL;
        const unsigned int before = (side + 3) % 4;
        for (unsigned int a = 0; a < n_per_side; ++a)
          for (unsigned int b = 0; b < n_per_side; ++b)
            error = std::min(
                error, (found - 0.5 * (wanted[before * n_per_side + a].stress +
                                       wanted[side * n_per_side + b].stress))
                           .norm());
      }
      largest = std::max(largest, error);
    }
    side = is_short ? side : side + 1;
  }
  return largest;
}

/** Whether a cell whose sides are not left out is solved. */
bool is_solved(const double h, CellStress &cell_stress)
{
  const std::vector<Point<2>> vertices = without_corners(h, 1);
  std::vector<SubCellStress> sub_cells(cell_stress.n_sub_cells());
  return cell_stress.solve({{},
                            vertices,
                            forces_of(uneven, vertices),
                            std::vector<Tensor<1, 2>>(vertices.size())},
                           {sub_cells.data(), sub_cells.size()});
}

void run()
{
  for (const unsigned int n_cut : {1U, 2U, 3U})
    for (const double h : {1e-5, 1e-9, 1e-13})
    {
      std::cout << n_cut << " sides of " << h << " at a corner" << std::endl;
      // Without a side of length h the force on it, of that size, acts half a
      // side away from its place.
      const double bound = 20. * h + 1e-13;
      Fan fan(4);
      LeastNorm coarse(4, 0, 0), rich(4, 0, 1), fine(4, 2, 0);
      for (const auto &[name, cut, cell_stress] : std::initializer_list<
               std::tuple<std::string, SubTriangulation, CellStress *>>{
               {"standard", SubTriangulation::fan(), &fan},
               {"degree 0", SubTriangulation::thirds(0), &coarse},
               {"degree 1", SubTriangulation::thirds(0), &rich},
               {"2 refinements", SubTriangulation::thirds(2), &fine}})
      {
        check_error("  " + name + ", uneven",
                    distance(uneven, false, h, n_cut, cut, *cell_stress),
                    bound);
        check_error("  " + name + ", uneven with couples",
                    distance(uneven, true, h, n_cut, cut, *cell_stress), bound);
        for (const bool with_couples : {false, true})
          check_error(
              with_couples ? "  the same with couples" : "  " + name + ", even",
              distance(even, with_couples, h, n_cut, cut, *cell_stress), 1e-13);
      }
    }

  // Any forces, with a resultant and a torque.
  LoadedCell any = loaded(uneven, true, without_corners(1e-2, 3));
  for (unsigned int i = 0; i < any.forces.size(); ++i)
    any.shifts[i] += (any.forces[i] += Tensor<1, 2>({0.1, 0.2 + 0.1 * i}));
  any.body_forces.assign(any.forces.size(), Tensor<1, 2>({0.3, -0.2}));
  ShortSides short_sides(SubTriangulation::fan(), 0.1);
  check("sides are left out", short_sides.leave_out(any));
  Tensor<1, 2> resultant;
  for (const auto &force : any.forces)
    resultant += force;
  for (const auto &force : short_sides.rest().forces)
    resultant -= force;
  check_error("resultant", resultant.norm(), 1e-14);
  check_error("torque", std::abs(torque(short_sides.rest()) - torque(any)),
              1e-14);

  // Long chains of short sides are no corner: a regular polygon stays one.
  std::vector<Point<2>> round;
  for (unsigned int i = 0; i < 1000; ++i)
    round.emplace_back(std::cos(2. * dealii::numbers::PI * i / 1000),
                       std::sin(2. * dealii::numbers::PI * i / 1000));
  const std::vector<Tensor<1, 2>> nothing(round.size());
  const LoadedCell round_cell = {{}, round, nothing, nothing};
  ShortSides fine_chain(SubTriangulation::fan(), 1e-3);
  check("no side is short", !fine_chain.leave_out(round_cell));
  ShortSides coarse_chain(SubTriangulation::fan(), 0.1);
  check("a chain is cut where it is as long as the shortest side",
        coarse_chain.leave_out(round_cell) &&
            std::abs(signed_area(coarse_chain.rest().vertices) -
                     dealii::numbers::PI) < 0.05);

  Fan fan(6);
  LeastNorm fine(6, 0, 0);
  for (const double h : {1e-2, 1e-3, 1e-4})
    check("sides of " + std::to_string(h),
          is_solved(h, fan) && is_solved(h, fine));
  check("sides of 1e-8, standard", is_solved(1e-8, fan));
  for (const double h : {1e-9, 1e-10})
    check("sides of 1e-9 or less, fine, are refused", !is_solved(h, fine));
  check("sides of 1e-12, standard, are refused", !is_solved(1e-12, fan));
}

const RoomTest test("short_sides", run);
} // namespace test_short_sides
