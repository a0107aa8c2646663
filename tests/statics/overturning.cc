// SPDX-License-Identifier: LGPL-2.1-or-later

// Forces without rotations either have couples that balance every block, and
// then the load is carried with rotations as well, or they would overturn
// blocks: those above the bed joint from which the resultant is too far.

#include <voussoir/scene/proofs/overturning.h>
#include <voussoir/scene/supports.h>

#include "judgement.h"
#include "room.h"

namespace test_overturning
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

constexpr double strength = 10.;

Scene under(Packing<2> packing,
            const Tensor<1, 2> &b,
            const Kinematics &kinematics = translations())
{
  packing.support(boundary_edges_where(packing, "y < 1e-9", ""));
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  loads.body =
      BodyForce(packing, [=](const Point<2> &, unsigned int) { return b; });
  const std::vector<double> strengths(packing.interfaces().size(), strength);
  return Scene(std::move(packing), strengths, std::move(loads), kinematics);
}

std::optional<Overturning> overturning(const Scene &scene)
{
  return find_overturning(scene, Solver(least_energy).forces(scene));
}

Packing<2> column()
{
  CellLoops cells;
  for (unsigned int k = 0; k <= 10; ++k)
  {
    cells.vertices.emplace_back(0., 0.1 * k);
    cells.vertices.emplace_back(0.3, 0.1 * k);
    if (k == 10)
      break;
    for (const unsigned int v : {0, 1, 3, 2})
      cells.loops.push_back(2 * k + v);
    cells.first.push_back(cells.loops.size());
  }
  return Packing<2>(cells);
}

/**
 * A column of 10 blocks, 0.3 wide and 1 high. On the k lowest bed joint act
 * the weight above, w, and the share of it, at (1 - k / 10) / 2 above.
 */
void try_column(const double share)
{
  std::cout << "share " << share << std::endl;
  const Scene scene = under(column(), Tensor<1, 2>({share, -1.}));
  const auto found = overturning(scene);
  const auto arm = [&](const unsigned int k) { return share * (10 - k) / 20.; };
  unsigned int k = 0;
  for (unsigned int i = 1; i < 10; ++i)
    // What a joint lacks, the weight above times the arm less half the width.
    if ((10 - i) * (arm(i) - 0.15) > (10 - k) * (arm(k) - 0.15))
      k = i;
  const double weight = 0.03 * (10 - k);
  check("overturning is found", found.has_value() == (arm(0) > 0.15));
  if (!found)
    return;
  check("  of the blocks above the lowest joint",
        found->cells.size() == 10 - k && found->interfaces.size() == 1);
  check_error("  moment", std::abs(found->moment + weight * arm(k)), 1e-12);
  check_error("  resistance", std::abs(found->resistance - weight * 0.15),
              1e-12);
}

/** Where no overturning is found the load is carried with rotations. */
void try_random_cells()
{
  unsigned int n_held = 0, n_overturning = 0, n_wrong = 0;
  for (unsigned int seed = 1; seed <= 60; ++seed)
  {
    const Tensor<1, 2> b({0.02 * seed, -1.});
    const Packing<2> packing =
        random_packing(20, seed, {{0., 0.}, {1., 1. + 0.1 * (seed % 7)}});
    if (overturning(under(packing, b)))
      ++n_overturning;
    else
    {
      ++n_held;
      n_wrong += judge(under(packing, b, rotations()), least_energy).verdict !=
                 Verdict::carried;
    }
  }
  check("both happen", n_held > 5 && n_overturning > 5);
  check("none that is held collapses", n_wrong == 0);
}

void run()
{
  for (const double share : {0.1, 0.2999, 0.3001, 0.5})
    try_column(share);
  try_random_cells();

  // Two packings of which one has no torque, and rounding is no torque.
  // Shear on a wall that nothing presses.
  const Scene shear = shear_wall(1.);
  const auto found = overturning(shear);
  check("nothing holds a couple without pressure",
        found && found->resistance < 1e-9 * std::abs(found->moment));
}

const RoomTest test("overturning", run);
} // namespace test_overturning
