// SPDX-License-Identifier: LGPL-2.1-or-later

// Loads made of the weights: towers that overturn as one by moments added up
// here, with weights of the blocks, forces on them and tractions, in proportion
// to the mass and to mass and height, both ways; sums in random cells.

#include <voussoir/analyses/factors/load_factor.h>
#include <voussoir/scene/loads/earthquake.h>

#include "tests.h"

namespace test_earthquake
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

struct Both
{
  Loads dead, live;
};

Both loads_of(const Packing<2> &packing,
              const std::string &dead,
              const std::string &earthquake)
{
  LoadParameters loads;
  Earthquake of;
  dealii::ParameterHandler prm;
  loads.add_parameters(prm);
  of.add_parameters(prm);
  prm.parse_input_from_string("subsection Loads\n" + dead +
                              "\nend\nsubsection Live loads\n"
                              "subsection Earthquake\n" +
                              earthquake + "\nend\nend\n");
  Both both = {loads.loads(packing), {}};
  both.live = of.loads(packing, both.dead);
  return both;
}

double factor_of(const Packing<2> &packing, const Both &loads, const bool most)
{
  const std::vector<double> strengths(packing.interfaces().size(), 1e4);
  LoadFactorControls controls;
  controls.greatest = most;
  controls.tolerance = 1e-10;
  return find_load_factor(Scene(packing, strengths, loads.dead, rotations()),
                          Scene(packing, strengths, loads.live, rotations()),
                          controls, Terminal::silent())
      .factor->carried;
}

/** A weight with its place. */
struct Weight
{
  double size;
  Point<2> at;
};

/** A tower as wide as one that overturns as a whole, by moments. */
void overturns(const std::string &what,
               const Packing<2> &tower,
               const std::string &dead,
               const std::vector<Weight> &weights)
{
  double W = 0., Wz = 0., Wzz = 0., Wx = 0.;
  for (const Weight &of : weights)
  {
    W += of.size;
    Wx += of.size * of.at[0];
    Wz += of.size * of.at[1];
    Wzz += of.size * of.at[1] * of.at[1];
  }
  for (const bool to_the_right : {true, false})
  {
    const double arm = to_the_right ? W - Wx : -Wx;
    const std::string way = to_the_right ? " to the right" : " to the left";
    check_error(
        what + way + ": mass",
        std::abs(factor_of(tower, loads_of(tower, dead, "set Pattern = mass"),
                           to_the_right) -
                 arm / Wz),
        1e-9);
    check_error(what + way + ": mass and height",
                std::abs(factor_of(tower,
                                   loads_of(tower, dead,
                                            "set Pattern = mass and height"),
                                   to_the_right) -
                         arm * Wz / (W * Wzz)),
                1e-9);
  }
}

void random_cells()
{
  const Packing<2> packing = random_packing(40, 3);
  const std::string dead = "set Body force = 0.2*y; -1-x*y\n"
                           "set Traction = 0.1; -0.3*x\n"
                           "set Cell forces = at 0.3, 0.4: 0.1, -0.2";
  const Both mass =
      loads_of(packing, dead, "set Pattern = mass\nset Direction = 3, 4");
  const double weight = -mass.dead.requested->force()[1];
  check_error(
      "random cells: the weights turned",
      (mass.live.requested->force() - weight * Point<2>(0.6, 0.8)).norm() /
          weight,
      1e-13);
  const Both height = loads_of(packing, dead,
                               "set Pattern = mass and height\n"
                               "set Direction = 1, 0");
  check_error("in all as large by height",
              std::abs(height.live.requested->force()[0] / weight - 1.), 1e-13);
  for (const Both *of : {&mass, &height})
  {
    Resultant sum(reference_point(packing));
    for (unsigned int c = 0; c < packing.n_cells(); ++c)
      sum.add(packing.centre(c), of->live.body.force(packing, c),
              of->live.body.torque(c));
    for (const CellForce &force : of->live.on_cells)
      sum.add(*force.place, force.force);
    for (unsigned int b = 0; b < of->live.traction.size(); ++b)
      sum.add(packing.boundary_edges()[b], of->live.traction[b],
              of->live.traction_moment[b]);
    check_error("what is asked for is what acts",
                (sum.force() - of->live.requested->force()).norm() +
                    std::abs(sum.moment() - of->live.requested->moment()),
                1e-13);
  }
}

void run()
{
  const Packing<2> tower = on_ground(stack_of_squares(4));
  std::vector<Weight> weights;
  for (unsigned int k = 0; k < 4; ++k)
    weights.push_back({2., Point<2>(0.5, k + 0.5)});
  overturns("four squares", tower, "set Body force = 0; -2", weights);
  weights.push_back({3., Point<2>(0.2, 2.7)});
  weights.push_back({0.5, Point<2>(0.5, 4.)});
  overturns("with a force and a traction", tower,
            "set Body force = 0; -2\nset Cell forces = cell 2: 0, -3 at 0.2, "
            "2.7\nset Segment tractions = 0, 4 to 1, 4: 0, -0.5",
            weights);
  random_cells();
  const auto refuse = [&](const std::string &dead,
                          const std::string &settings) {
    show_refusal([&] { loads_of(tower, dead, settings); });
  };
  refuse("set Body force = 0; -2", "set Pattern = mass\nset Direction = 0, 0");
  refuse("set Body force = 0; -2", "set Pattern = mass\nset Direction = left");
  refuse("set Body force = 2; 0", "set Pattern = mass");
}

const RoomTest test("earthquake", run);
} // namespace test_earthquake
