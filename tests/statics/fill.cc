// SPDX-License-Identifier: LGPL-2.1-or-later

// Soil beside and above blocks: its weight and its pressure against closed
// forms, with the depths at which they act; a block that is pushed into it
// fails at the passive pressure and one that yields at the active one. What it
// spreads of a force is the force, in its place, for both laws.

#include <voussoir/analyses/factors/load_factor.h>
#include <voussoir/scene/links/fill.h>

#include "tests.h"

namespace test_fill
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

FillOnBlocks soil_on(const Packing<2> &packing, const std::string &entries)
{
  Fill fill;
  dealii::ParameterHandler prm;
  fill.add_parameters(prm, {"soil"});
  prm.parse_input_from_string("subsection Fill\nsubsection soil\n" + entries +
                              "\nend\nend\n");
  return fill.on(packing);
}

/** The sums of tractions, and of their moments about the origin. */
std::array<double, 3> sums_of(const Packing<2> &packing, const Loads &loads)
{
  Resultant sum({0., 0.});
  for (unsigned int b = 0; b < loads.traction.size(); ++b)
    sum.add(packing.boundary_edges()[b], loads.traction[b],
            loads.traction_moment[b]);
  return {{sum.force()[0], sum.force()[1], sum.moment()}};
}

/**
 * A block of 1 x 2 with soil of weight 18 up to y = 3 above and on its right:
 * on top 18 x 1, and at the side 18 (3 - y), which over the height is 72 at the
 * distance (3 x 4/2 - 8/3) / 4 = 5/6 from the ground.
 */
void block()
{
  const Packing<2> packing = on_ground(wall(1, 1, 1., 2.));
  const std::string soil = "set Where = nx > 0.9 || ny > 0.9\nset Top = 3\nset "
                           "Unit weight = 18\n";
  const FillOnBlocks with = soil_on(
      packing,
      soil + "set Active coefficient = 0.3\nset Passive coefficient = 3.5");
  const auto sums = sums_of(packing, with.loads);
  check_error("the weight above", std::abs(sums[1] + 18.), 1e-12);
  check_error("in its middle", std::abs(sums[2] + 9.), 1e-12);
  check("one link at the side", with.links.size() == 1);
  const Link &side = with.links.at(0);
  check_error("its least and most pressure",
              std::abs(side.most + 0.3 * 72.) +
                  std::abs(side.least + 3.5 * 72.),
              1e-10);
  check_error("its place", side.on_minus.distance(Point<2>(1., 5. / 6.)),
              1e-12);
  check("without a passive coefficient there is none",
        soil_on(packing, soil).links.empty());
  const auto loaded = sums_of(
      packing,
      soil_on(packing, "set Where = ny > 0.9\nset Top = x < 0.5 ? 3 : 2\nset "
                       "Unit weight = 18\nset Surcharge = 4")
          .loads);
  check_error("a step, with a surcharge on what is covered",
              std::abs(loaded[1] + 0.5 * 22.) + std::abs(loaded[2] + 2.75),
              1e-10);

  for (const double sense : {1., -1.})
  {
    const auto scene = [&](const double weight, const double push,
                           const std::vector<Link> &links) {
      Loads loads;
      loads.traction.resize(packing.boundary_edges().size());
      loads.on_cells = {{"cell 0", {0}, Point<2>(push, -weight)}};
      Scene of(packing, std::vector<double>(1, 0.), loads, translations(),
               links);
      return of;
    };
    LoadFactorControls controls;
    controls.greatest = sense > 0.;
    const LoadFactor found =
        *find_load_factor(scene(5., 0., with.links),
                          scene(0., 1., without_rest(with.links)), controls,
                          Terminal::silent())
             .factor;
    const double expected = sense > 0. ? 3.5 * 72. : 0.3 * 72.;
    check_error(sense > 0. ? "pushed it fails at the passive pressure"
                           : "held it fails at the active one",
                std::abs(found.carried - expected) +
                    std::abs(found.bound - expected),
                1e-9 * expected);
    check("the loads alone are not carried", found.collapses_without);
  }
}

/**
 * On level ground at depth 2 a force at x = 0 comes with a constant stress
 * between -1 and 1 for rays within 1:2, and with the share
 * 2 z^3 / (pi r^4) of Flamant's, cut off at 45 degrees.
 */
void spreading()
{
  const unsigned int n = 64;
  Packing<2> row = on_ground(wall(1, n, 8., 1.));
  const auto forces = [&](const std::string &entries, const double x) {
    const FillOnBlocks soil =
        soil_on(row, "set Where = ny > 0.9\nset Top = 3\n" + entries);
    return soil.spreading.at(0).forces(row, x, 10.);
  };
  for (const std::string &entries :
       {std::string("set Spreading = uniform\nset Spreading angle = "
                    "26.56505117707799"),
        std::string("set Spreading = elastic\nset Spreading angle = 45")})
  {
    const bool is_uniform = entries.find("uniform") != entries.npos;
    double sum = 0., moment = 0., of_stress = 0.;
    for (const CellForce &force : forces(entries, 4.))
    {
      sum += force.force[1];
      moment += force.force[1] * ((*force.place)[0] - 4.);
      const double x = (*force.place)[0] - 4.;
      const double width = 8. / n;
      // The mean over a brick, by Simpson's rule, whose error is below 1e-5.
      const auto stress = [&](const double at) {
        const double r = std::hypot(at, 2.);
        const double all = 0.5 + 1. / dealii::numbers::PI; // within 45 degrees
        return is_uniform
                   ? 5.
                   : 20. / dealii::numbers::PI * 8. / std::pow(r, 4) / all;
      };
      const double middle = (std::floor((x + 4.) / width) + 0.5) * width - 4.;
      const double mean = (stress(middle - width / 2.) + 4. * stress(middle) +
                           stress(middle + width / 2.)) /
                          6.;
      of_stress = std::max(of_stress, std::abs(force.force[1] + mean * width));
    }
    const std::string law = is_uniform ? "uniform" : "elastic";
    check_error(law + ": the force", std::abs(sum + 10.), 1e-12);
    check_error(law + ": its place", std::abs(moment), 1e-12);
    check_error(law + ": its stress", of_stress, 1e-5);
    double beside = 0.;
    for (const CellForce &force : forces(entries, 0.))
      beside += force.force[1];
    check_error(law + ": at an end half of it", std::abs(beside + 5.), 1e-12);
    check(law + ": far away nothing", forces(entries, -3.).empty());
  }

  // Over an arch all of it arrives, whatever the slopes, if no ray goes beside;
  // nothing is seen twice.
  const Packing<2> ring = on_ground(semicircle(30, 0.2));
  for (const char *const law : {"uniform", "elastic"})
  {
    const FillOnBlocks soil =
        soil_on(ring, std::string("set Where = x * nx + y * ny > 0.1\nset Top "
                                  "= 1.5\nset Spreading = ") +
                          law);
    double error = 0.;
    for (const double x : {-0.37, -0.2, 0., 0.3})
    {
      double sum = 0.;
      for (const CellForce &force : soil.spreading.at(0).forces(ring, x, 3.))
        sum += force.force[1];
      error = std::max(error, std::abs(sum + 3.));
    }
    check_error(std::string(law) + ": over an arch", error, 1e-12);
  }
}

void run()
{
  block();
  spreading();
  const Packing<2> one = on_ground(wall(1, 1));
  for (const char *const entries :
       {"set Where = ny > 2", "set Where = 1\nset Active coefficient = 2",
        "set Where = 1\nset Top = 1 / (x - 0.5)\nset Unit weight = 1",
        "set Where = ny > 0\nset Top = z"})
    show_refusal([&] { soil_on(one, entries); });
  show_refusal([&] {
    Fill fill;
    dealii::ParameterHandler prm;
    fill.add_parameters(prm, {"soil, wet"});
  });
}

const RoomTest test("fill", run);
} // namespace test_fill
