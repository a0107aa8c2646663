// SPDX-License-Identifier: LGPL-2.1-or-later

// A rectangular block between two forces on opposite sides, which balance
// although they act beside the midpoints. The stress has the resultant and the
// couple through each side, on its own trace, and the mean stress of these
// forces, symmetric in the mean; the refined one has no divergence. It is the
// same in any units, also in a block so slender that it is checked turned.

#include <voussoir/base/geometry.h>
#include <voussoir/stress/fan.h>
#include <voussoir/stress/least_norm.h>

#include "tests.h"

namespace test_couples
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** A reconstruction whose fluxes can be seen, in a cell of unit area. */
template <typename Base>
struct Fluxes : public Base
{
  using Base::Base;

  /**
   * Component @p row of the forces on the halves of all sides without those of
   * the mean; for degree 0, by which divergence() is the flux of phi_k.
   */
  std::vector<double> on_halves(const unsigned int row) const
  {
    std::vector<double> result(2 * this->forces.size());
    for_each_flux([&](const unsigned int s, const unsigned int k) {
      const CellSpaces::Flux &flux = this->spaces.flux(s, k);
      if (flux.unknown == dealii::numbers::invalid_unsigned_int)
        result[flux.half] +=
            this->coefficient(row, s, k) * this->spaces.divergence(s, 0, k);
    });
    return result;
  }

  /** The integral of what is not the symmetric mean. */
  Tensor<2, 2> integral() const
  {
    Tensor<2, 2> result;
    for_each_flux([&](const unsigned int s, const unsigned int k) {
      const CellSpaces::Integrals &integrals = this->spaces.integrals(s);
      for (unsigned int row = 0; row < 2; ++row)
        for (unsigned int j = 0; j < integrals.mean.size(); ++j)
          result[row] += this->coefficient(row, s, k) * integrals.moment(j, k);
    });
    return result;
  }

private:
  template <typename Action>
  void for_each_flux(const Action &action) const
  {
    for (unsigned int s = 0; s < this->n_sub_cells(); ++s)
      for (unsigned int k = 0; k < this->spaces.n_fluxes_per_sub_cell(); ++k)
        action(s, k);
  }
};

/**
 * A block of unit area times @p scale^2 between the force (shear, -1) on top
 * and its opposite below, in a straight line at @p top and @p bottom from the
 * midpoints of these sides; the vertical parts alone have couples.
 */
LoadedCell block(const double height,
                 const double bottom,
                 const double top,
                 const double scale)
{
  const double width = 1. / height;
  LoadedCell cell;
  for (const Point<2> &x : {Point<2>(0., 0.), Point<2>(width, 0.),
                            Point<2>(width, height), Point<2>(0., height)})
    cell.vertices.emplace_back(scale * x);
  cell.centre = Point<2>(0.5 * scale * width, 0.4 * scale * height);
  cell.forces.resize(4);
  cell.body_forces.resize(4);
  cell.shifts.resize(4);
  const double shear = (bottom - top) / height;
  cell.forces[0] = scale * Tensor<1, 2>({-shear, 1.});
  cell.forces[2] = scale * Tensor<1, 2>({shear, -1.});
  // A force f at a distance a from the midpoint towards the second half.
  cell.shifts[0] = scale * Tensor<1, 2>({0., 2. * bottom / width});
  cell.shifts[2] = scale * Tensor<1, 2>({0., 2. * top / width});
  return cell;
}

/** The mean stress, from the distances of the opposite forces. */
Tensor<2, 2> thrust(const double bottom, const double top)
{
  return tensor(0., bottom - top, bottom - top, -2.);
}

template <typename Solver>
void compare(Fluxes<Solver> &solver, const double bottom, const double top)
{
  const LoadedCell cell = block(2., bottom, top, 1.);
  const Tensor<2, 2> mean = thrust(bottom, top);
  check_error("  forces have this mean", (cell.moments() - mean).norm(), 1e-15);

  std::vector<SubCellStress> sub_cells(solver.n_sub_cells());
  check("  a unique answer",
        solver.solve(cell, {sub_cells.data(), sub_cells.size()}));
  const Tensor<2, 2> rest = solver.integral();
  check_error("  skew part of the mean", std::abs(rest[0][1] - rest[1][0]),
              1e-13);

  double resultant = 0., couple = 0.;
  const std::vector<double> of_x = solver.on_halves(0),
                            of_y = solver.on_halves(1);
  for (unsigned int i = 0; i < 4; ++i)
  {
    const Tensor<1, 2> half = 0.5 * cell.side(i);
    const auto on_half = [&](const unsigned int h) -> Tensor<1, 2> {
      return Tensor<1, 2>({of_x[h], of_y[h]}) +
             mean * Tensor<1, 2>({half[1], -half[0]});
    };
    const Tensor<1, 2> first = on_half(2 * i), second = on_half(2 * i + 1);
    resultant = std::max(resultant, (first + second - cell.forces[i]).norm());
    // Below the force (0, 1) at a distance "bottom" to the right, on top
    // (0, -1) at "top".
    const double wanted = i == 0 ? bottom : i == 2 ? -top : 0.;
    couple =
        std::max(couple, std::abs(0.5 * cross(half, second - first) - wanted));
  }
  check_error("  resultants on the trace", resultant, 1e-13);
  check_error("  couples on the trace", couple, 1e-13);

  const double scale = 3e5;
  const LoadedCell large = block(2., bottom, top, scale);
  std::vector<SubCellStress> in_large(solver.n_sub_cells());
  check("  a unique answer in other units",
        solver.solve(large, {in_large.data(), in_large.size()}));
  double skew = 0., divergence = 0., difference = 0.;
  for (unsigned int s = 0; s < sub_cells.size(); ++s)
  {
    skew = std::max(
        skew, std::abs(sub_cells[s].stress[0][1] - sub_cells[s].stress[1][0]));
    divergence = std::max(divergence, sub_cells[s].divergence.norm());
    difference =
        std::max(difference, (in_large[s].stress - sub_cells[s].stress).norm());
  }
  check_error("  the same in other units", difference, 1e-11);
  if (sub_cells.size() > 4)
  {
    check_error("  div sigma in each sub-cell", divergence, 1e-12);
    check_error("  mean stress", rest.norm(), 1e-13);
  }
  else
    check_error("  skew part in each sub-cell", skew, 1e-12);
}

void run()
{
  Fluxes<Fan> fan(4);
  Fluxes<LeastNorm> coarse(4, 0, 0), fine(4, 1, 0);
  for (const auto &[bottom, top] :
       {std::make_pair(0.1, 0.1), std::make_pair(0.1, 0.02),
        std::make_pair(0.2, -0.25)})
  {
    std::cout << bottom << " below, " << top << " on top, standard"
              << std::endl;
    compare(fan, bottom, top);
    std::cout << bottom << " below, " << top << " on top, fine" << std::endl;
    compare(coarse, bottom, top);
    std::cout << bottom << " below, " << top << " on top, refined" << std::endl;
    compare(fine, bottom, top);
  }

  LeastNorm rich(4, 0, 1);
  std::vector<SubCellStress> sub_cells(rich.n_sub_cells());
  rich.solve(block(2., 0.1, 0.02, 1.), {sub_cells.data(), sub_cells.size()});
  double divergence = 0.;
  for (const SubCellStress &sub_cell : sub_cells)
    divergence = std::max(divergence, sub_cell.divergence.norm());
  check_error("degree 1: div sigma in each sub-cell", divergence, 1e-12);

  // 400 times as high as wide.
  const double height = 20.;
  for (CellStress *solver :
       {static_cast<CellStress *>(&fan), static_cast<CellStress *>(&coarse)})
  {
    sub_cells.resize(solver->n_sub_cells());
    check("a slender block",
          solver->solve(block(height, 0.01, -0.006, 1.),
                        {sub_cells.data(), sub_cells.size()}));
  }
}

const RoomTest test("couples", run);
} // namespace test_couples
