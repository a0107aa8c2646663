// SPDX-License-Identifier: LGPL-2.1-or-later

// Factors of the strengths against sliding: closed forms of blocks and arches,
// with both proofs; blocks that wedge, where the share of the loads that is
// carried jumps.

#include <voussoir/algebra/vectors.h>
#include <voussoir/analyses/factors/factor_entries.h>
#include <voussoir/analyses/factors/strength_factor.h>
#include <voussoir/scene/proofs/certificate.h>

#include "coulomb_scenes.h"
#include "tests.h"

namespace test_strength_factors
{
using namespace Voussoir;
using dealii::Tensor;

/** Both proofs of a strength factor, and the exact one. */
void compare(const std::string &name, const Scene &scene, const double exact)
{
  const LoadFactorAnswer answer =
      find_strength_factor(scene, {}, Terminal::silent());
  check(name, answer.factor.has_value());
  const LoadFactor &found = *answer.factor;
  check_error(
      "  state",
      certify(with_strengths_divided(scene, found.carried), found.forces)
          .error(),
      1e-10);
  check("  mechanism",
        proves_collapse(certify_mechanism(
            with_strengths_divided(scene, found.bound), found.mechanism)));
  check_error("  factor", std::abs(found.carried / exact - 1.), 1e-7);
  check_error("  bound", std::abs(found.bound / exact - 1.), 1e-7);
}

void strengths()
{
  compare("a dry block", wall_under(1, 1, 2., -10., 0.6, 0.), 3.);
  compare("just rough enough", wall_under(1, 1, 6., -10., 0.6, 0.), 1.);
  compare("rougher than the push asks for", wall_under(1, 1, 2., -10., 0.1, 0.),
          0.5);
  // mu W + c L = H v with W = 10 * 0.07, L = 0.4, H = 2 * 0.07
  compare("with cohesion", wall_under(1, 1, 2., -10., 0.2, 0.35),
          (0.2 * 0.7 + 0.35 * 0.4) / 0.14);
  const LoadFactorAnswer upright = find_strength_factor(
      wall_under(3, 3, 0., -10., 0.6, 0.), {}, Terminal::silent());
  check("without a push no strength is needed",
        upright.factor && upright.factor->is_unbounded);
  const LoadFactorAnswer overturns = find_strength_factor(
      wall_under(1, 1, 30., -10., 0.6, 0.), {}, Terminal::silent());
  check("what overturns does with any strength", !overturns.factor);
}

/**
 * The least coefficient of a semicircular arch: by H / V at the springing,
 * where the thrust of the thinnest arch is the only one; and where it slides.
 */
void arch(const double thickness, const double exact, const double error)
{
  const Scene scene = under(on_ground(semicircle(160, thickness)),
                            Tensor<1, 2>({0., -20.}), 0.6, 0.);
  const LoadFactorAnswer answer =
      find_strength_factor(scene, {}, Terminal::silent());
  check("an arch", answer.factor.has_value());
  check_error("  its coefficient",
              std::abs(0.6 / answer.factor->carried / exact - 1.), error);
}

void arches()
{
  // The weight of an annular sector is a little outside of the middle line;
  // hinges at the extrados of the springings and the crown.
  const double thickness = 0.10748, half = 0.5 * dealii::numbers::PI;
  const double weight_at = 1. + thickness * thickness / 12.;
  arch(thickness, (half - weight_at / (1. + 0.5 * thickness)) / half, 1e-4);
  // Cocchetti and Rizzi (2020), for many voussoirs
  arch(0.21, 0.309215, 2e-4);
}

/** A block of height 1 and width 1 at mid-height, wider below by 2 taper, with
 * walls at both sides that do not move. */
Scene between_walls(const double taper, const double mu)
{
  CellLoops cells;
  cells.vertices = {{-0.5 - 0.5 * taper, 0.},
                    {0.5 + 0.5 * taper, 0.},
                    {0.5 - 0.5 * taper, 1.},
                    {-0.5 + 0.5 * taper, 1.}};
  cells.loops = {0, 1, 2, 3};
  cells.first.push_back(cells.loops.size());
  Packing<2> packing(cells);
  std::vector<bool> walls;
  for (const auto &edge : packing.boundary_edges())
    walls.push_back(std::abs(edge.midpoint()[0]) > 0.1);
  packing.support(walls);
  return under(packing, Tensor<1, 2>({0., -10.}), mu, 0.);
}

void walls_at_both_sides()
{
  // Pressed to either wall by any N, it is held by 2 mu N / f.
  const LoadFactorAnswer upright =
      find_strength_factor(between_walls(0., 0.6), {}, Terminal::silent());
  check("between upright walls any strength does",
        upright.factor && !upright.factor->has_mechanism() &&
            upright.factor->carried > 1e4);
  const double needed = 10. * upright.factor->carried / (2. * 0.6);
  check("  the force that it takes",
        -upright.factor->forces.normal[0] > needed * (1. - 1e-9));
  check("  in words",
        sentence_of(*upright.factor, FactorEntries::Factor::strength)
                .find("the greater are the forces") != std::string::npos);

  // Where the walls lean by t it wedges with mu/f > t, and falls otherwise: of
  // forces along both friction cones the sum is upwards.
  for (const double taper : {0.3, 0.02})
  {
    const double exact = 0.6 / taper;
    const Scene scene = between_walls(taper, 0.6);
    const LoadFactorAnswer leaning =
        find_strength_factor(scene, {}, Terminal::silent());
    check("between leaning walls", leaning.factor.has_value());
    const LoadFactor &found = *leaning.factor;
    check("  the factor is between both proofs",
          found.carried <= exact * (1. + 1e-12) &&
              found.bound >= exact * (1. - 1e-12));
    // Over forces that are far greater than the weight of 10.
    check_error(
        "  state, over its forces",
        certify(with_strengths_divided(scene, found.carried), found.forces)
                .error() *
            10. / largest_component(found.forces.normal),
        1e-13);
    check("  mechanism",
          proves_collapse(certify_mechanism(
              with_strengths_divided(scene, found.bound), found.mechanism)));
    check("  it says so", found.is_at_jump);
    check_error("  their distance", found.width(), 1e-3);
    check("  iterations", found.n_iterations < 1000);
  }
}

void run()
{
  strengths();
  arches();
  walls_at_both_sides();
}

const RoomTest test("strength_factors", run);
} // namespace test_strength_factors
