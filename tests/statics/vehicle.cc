// SPDX-License-Identifier: LGPL-2.1-or-later

// Vehicles: each axle acts downwards on the highest block at its place, with
// its share of a width; blocks that meet there share it, and beside the blocks
// there is nothing. Their sums and moments are those of the axles, in curved,
// stepped and random packings.

#include <voussoir/scene/loads/loads.h>

#include "tests.h"
#include <algorithm>
#include <cmath>
#include <random>

namespace test_vehicle
{
using namespace Voussoir;

Loads loads_on(const Packing<2> &packing, const std::string &settings)
{
  LoadParameters loads("Live loads");
  dealii::ParameterHandler prm;
  loads.add_parameters(prm);
  prm.parse_input_from_string("subsection Live loads\nsubsection Vehicle\n" +
                              settings + "\nend\nend\n");
  return loads.loads(packing);
}

/** The highest point of all cells on a vertical line; none: -infinity. */
double top(const Packing<2> &packing, const double x)
{
  double y = -std::numeric_limits<double>::infinity();
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
    {
      const auto &a = packing.vertex(c, i), &b = packing.vertex(c, i + 1);
      if (std::min(a[0], b[0]) <= x && x <= std::max(a[0], b[0]) &&
          a[0] != b[0])
        y = std::max(y, a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]));
    }
  return y;
}

/** Sums and places of two axles anywhere. */
void try_packing(const std::string &name, const Packing<2> &packing)
{
  std::mt19937 random(7);
  double left = 1e9, right = -1e9;
  for (const auto &edge : packing.boundary_edges())
  {
    left = std::min(left, edge.start[0]);
    right = std::max(right, edge.start[0]);
  }
  const double d = 0.2 * (right - left);
  std::uniform_real_distribution<double> anywhere(left + d, right - d);
  double of_sum = 0., of_moment = 0., of_place = 0.;
  for (unsigned int n = 0; n < 100; ++n)
  {
    const double x = anywhere(random);
    const bool is_reversed = n % 2 == 1;
    const Loads loads =
        loads_on(packing, text("set Axles = 0: 3 | ", d, ": 5\nset Position = ",
                               dealii::Utilities::to_string(x, 17),
                               "\nset Effective width = 2\nset Reversed = ",
                               is_reversed ? "true" : "false"));
    const double x2 = is_reversed ? x - d : x + d;
    double sum = 0., moment = 0.;
    for (const CellForce &force : loads.on_cells)
    {
      const auto at = *force.place;
      sum += force.force[1];
      moment += at[0] * force.force[1];
      of_place = std::max({of_place, std::abs(force.force[0]),
                           std::abs(at[1] - top(packing, at[0]))});
    }
    of_sum = std::max(of_sum, std::abs(sum + 4.));
    of_moment = std::max(of_moment, std::abs(moment + 1.5 * x + 2.5 * x2));
  }
  check_error(name + ": the sum of two axles", of_sum, 1e-14);
  check_error(name + ": their moment", of_moment, 1e-12);
  check_error(name + ": they stand on top", of_place, 1e-12);
}

void refused(const Packing<2> &packing, const std::string &settings)
{
  try
  {
    loads_on(packing, settings);
    check("is refused", false);
  }
  catch (const InputError &error)
  {
    std::cout << error.what() << std::endl;
  }
}

void run()
{
  try_packing("a wall", wall(4, 3));
  try_packing("random cells", random_packing(200, 3));

  // A row of bricks: at a joint both have half, and each its own place.
  const Packing<2> row = wall(1, 4);
  const Loads at_joint = loads_on(row, "set Axles = 0: 3\nset Position = 0.5");
  check("at a joint two blocks share an axle",
        at_joint.on_cells.size() == 2 &&
            at_joint.on_cells[0].cells != at_joint.on_cells[1].cells &&
            at_joint.on_cells[0].force[1] == -1.5 &&
            at_joint.on_cells[1].force[1] == -1.5);
  const Loads inside = loads_on(row, "set Axles = 0: 3\nset Position = 0.6");
  check("elsewhere one has it",
        inside.on_cells.size() == 1 && inside.on_cells[0].force[1] == -3.);

  const Loads beside =
      loads_on(row, "set Axles = 0: 3 | 0.5: 1\nset Position = -0.2");
  check("beside the blocks there is none", beside.on_cells.size() == 1);
  std::cout << beside.warnings.at(0) << std::endl;
  check("without axles there is none",
        loads_on(row, "set Position = 0.3").on_cells.empty());
  const Loads known = loads_on(
      row, "set Axles = LM1\nset Position = 0.3\nset Effective width = 3");
  check("a vehicle by its name",
        known.on_cells.size() == 1 && known.on_cells[0].force[1] == -100.);

  refused(row, "set Axles = 300");
  refused(row, "set Axles = LM9");
  refused(row, "set Axles = a: 300");
  refused(row, "set Axles = 0: 300, 200");
  refused(row, "set Axles = 0: -300");
  refused(row, "set Axles = 0: 300\nset Effective width = 0");
}

const RoomTest test("vehicle", run);
} // namespace test_vehicle
