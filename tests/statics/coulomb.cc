// SPDX-License-Identifier: LGPL-2.1-or-later

// Coulomb's friction: states of blocks that slide without lifting, and their
// factors, which friction with dilatancy bounds; factors that do not depend on
// the units of the loads, and that are zero; what is said of factors that were
// tried; Anderson's acceleration of a linear fixed point.

#include <voussoir/algebra/anderson.h>
#include <voussoir/algebra/vectors.h>
#include <voussoir/analyses/factor_analysis.h>
#include <voussoir/analyses/factors/factor_without_dilatancy.h>
#include <voussoir/analyses/state/assess.h>
#include <voussoir/statics/energy/coulomb_state.h>
#include <voussoir/statics/energy/least_energy.h>

#include "coulomb_scenes.h"
#include "tests.h"

namespace test_coulomb
{
using namespace Voussoir;
using dealii::Tensor;

Scene without_dilatancy(Scene scene)
{
  scene.dilates = false;
  return scene;
}

/** The fixed point of states of least energy. */
const CoulombState &fixed_point()
{
  static const LeastEnergy least;
  static const CoulombState state(least);
  return state;
}

void states()
{
  for (const double push : {0.1, 0.3, 0.5})
  {
    Scene scene = wall_under(6, 5, 10. * push, -10., 0.65, 0.);
    scene.dilates = false;
    const DiscreteProblem problem = discretise(scene);
    std::string failure;
    const Solution found =
        fixed_point().find(problem, {}, failure, Terminal::silent());
    check("a state is found", found.converged());
    if (!found.converged())
      continue;
    const InterfaceForces forces = dimensional_forces(problem, found);
    const Certificate certificate = certify(scene, forces);
    check_error("  its error", certificate.error(), 1e-12);
    // Least energy with its own limits as strengths is the same state.
    std::vector<double> limits;
    for (unsigned int e = 0; e < forces.normal.size(); ++e)
      limits.push_back(-0.65 * forces.normal[e] /
                       (problem.stress_scale() * problem.length_scale()));
    const Solution again = LeastEnergy().solve(problem.with_tresca(limits), {},
                                               Terminal::silent());
    double difference = 0.;
    for (std::size_t k = 0; k < again.forces.size(); ++k)
      difference =
          std::max(difference, std::abs(again.forces[k] - found.forces[k]));
    check_error("  fixed point", difference / largest_component(found.forces),
                1e-7);
    check("  passes", found.passes.n > 1);
  }
  // Where the passes come to rest short of their fixed point, and many joints
  // slide.
  const auto state_of = [](const Scene &scene) {
    const DiscreteProblem problem = discretise(scene);
    return dimensional_forces(
        problem, fixed_point().solve(problem, {}, Terminal::silent()));
  };
  const Scene wide = without_dilatancy(wall_under(16, 10, 3.5, -10., 0.6, 0.));
  check_error("a wide wall: its error", certify(wide, state_of(wide)).error(),
              1e-12);
  const Scene high = without_dilatancy(wall_under(30, 10, 3.5, -10., 0.6, 0.));
  const InterfaceForces forces = state_of(high);
  const Certificate certificate = certify(high, forces);
  check_error("a high wall: its error", certificate.error(), 1e-9);
  check("  its loads are carried",
        assess(high, forces, certificate, Terminal::silent()).status.kind ==
            Status::Kind::solved);
  Scene steep = wall_under(6, 5, 8., -10., 0.65, 0.);
  steep.dilates = false;
  const Solution collapse =
      fixed_point().solve(discretise(steep), {}, Terminal::silent());
  check("too steep: a mechanism that opens as it slides",
        collapse.mechanism &&
            proves_collapse(certify_mechanism(
                steep,
                dimensional_motion(discretise(steep), *collapse.mechanism))));
}

void factors()
{
  Scene dead = wall_under(6, 5, 0., -10., 0.65, 0.);
  Scene live = wall_under(6, 5, 10., 0., 0.65, 0.);
  const LoadFactorAnswer associated =
      find_load_factor(dead, live, {}, Terminal::silent());
  dead.dilates = live.dilates = false;
  const LoadFactorAnswer found = find_factor_without_dilatancy(
      dead, live, fixed_point(), {}, {}, Terminal::silent());
  check("found", associated.factor && found.factor);
  check("the bound is that of friction with dilatancy",
        found.factor->bound == associated.factor->bound);
  check("and not exceeded",
        found.factor->carried <= (1. + 1e-10) * found.factor->bound &&
            found.factor->carried > 0.95 * associated.factor->carried);
  const Scene at =
      wall_under(6, 5, 10. * found.factor->carried, -10., 0.65, 0.);
  check_error("its state", certify(at, found.factor->forces).error(), 1e-9);
  const FactorTrials &trials = found.factor->trials;
  check("it is the greatest tried that has one",
        trials.with_state.back() == found.factor->carried);
  check("smaller ones were tried, in order",
        trials.with_state.size() > 8 &&
            std::is_sorted(trials.with_state.begin(), trials.with_state.end()));
  check("of a factor with two proofs nothing was tried",
        associated.factor->trials.empty());

  // It is a collapse of blocks that slide without lifting: its motion opens no
  // joint that is pressed, and friction is at its limit where they slide.
  check("a collapse of its own", found.factor->own_collapse.has_value());
  const FactorBound &own = *found.factor->own_collapse;
  check_error("  its motion proves the factor",
              std::abs(own.factor / found.factor->carried - 1.), 1e-7);
  check_error("  and closes no joint", own.closing_violation, 1e-12);
  const DiscreteProblem problem = discretise(at);
  const std::vector<double> f =
      nondimensional_forces(problem, found.factor->forces);
  const std::vector<double> jumps = problem.jumps(
      nondimensional_motion(problem, found.factor->mechanism, 1.));
  double pressing = 0., sliding = 0., short_of_limit = 0.;
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const unsigned int first = problem.first_row(e), n = problem.n_contacts(e);
    double normal = 0.;
    for (unsigned int r = 0; r < n; ++r)
    {
      pressing += std::abs(f[first + r] * jumps[first + r]);
      normal += f[first + r];
    }
    sliding += std::abs(f[first + n] * jumps[first + n]);
    short_of_limit += std::abs(-0.65 * normal * std::abs(jumps[first + n]) -
                               std::abs(f[first + n] * jumps[first + n]));
  }
  check("  it slides", sliding > 1e-3);
  check_error("  pressed joints do not open", pressing / sliding, 1e-5);
  check_error("  friction at its limit", short_of_limit / sliding, 1e-5);

  // Without dead loads: cohesion, and what friction adds to it.
  const LoadFactorAnswer cohesive = find_factor_without_dilatancy(
      without_dilatancy(wall_under(1, 1, 0., 0., 0.3, 1.)),
      without_dilatancy(wall_under(1, 1, 10., -10., 0.3, 1.)), fixed_point(),
      {}, {}, Terminal::silent());
  // a W = c L + mu a W with W = 10 * 0.07, L = 0.4
  check_error("all loads",
              std::abs(cohesive.factor->carried / (0.4 / 0.49) - 1.), 3e-6);
  const LoadFactorAnswer dry = find_factor_without_dilatancy(
      without_dilatancy(wall_under(1, 1, 0., 0., 0.3, 0.)),
      without_dilatancy(wall_under(1, 1, 10., -10., 0.3, 0.)), fixed_point(),
      {}, {}, Terminal::silent());
  check("dry, none of them", dry.factor->carried == 0.);

  // One block has nothing to lift: it slides at mu whatever the law.
  dead = wall_under(1, 1, 0., -10., 0.3, 0.);
  live = wall_under(1, 1, 10., 0., 0.3, 0.);
  dead.dilates = live.dilates = false;
  const LoadFactorAnswer block = find_factor_without_dilatancy(
      dead, live, fixed_point(), {}, {}, Terminal::silent());
  check_error("a block", std::abs(block.factor->carried / 0.3 - 1.), 3e-6);
}

void scales_and_zero()
{
  const Scene none = wall_under(3, 3, 0., 0., 0., 1.);
  double least = std::numeric_limits<double>::infinity(), most = 0.;
  for (const double size : {1e-9, 1e-3, 1., 1e6})
  {
    const LoadFactorAnswer answer = find_load_factor(
        none, wall_under(3, 3, size, -size, 0., 1.), {}, Terminal::silent());
    check("bounds in order",
          answer.factor->carried <= answer.factor->bound * (1. + 1e-12));
    least = std::min(least, size * answer.factor->carried);
    most = std::max(most, size * answer.factor->bound);
  }
  check_error("loads of any size", most / least - 1., 1e-8);

  const LoadFactorAnswer zero = find_load_factor(
      none, wall_under(3, 3, 10., 5., 0., 1.), {}, Terminal::silent());
  check("loads that overturn: no factor but zero",
        zero.factor && zero.factor->carried == 0. &&
            zero.factor->width() <= 1e-8 && zero.factor->has_mechanism());
}

void words()
{
  LoadFactor factor;
  factor.carried = 2.;
  factor.bound = 3.;
  factor.trials = {{0., 1., 2.}, {2.5, 3.}};
  std::cout << description_of(factor) << std::endl;
  factor.trials = {{0., 1., 2.}, {1.5, 2.5}};
  std::cout << description_of(factor) << std::endl;
  factor.trials = {{0., 2.}, {0.5, 1.5, 2.5}};
  std::cout << description_of(factor) << std::endl;
  factor.trials = {{0., 2.}, {2.5}};
  std::cout << description_of(factor) << std::endl;
  factor.carried = 0.;
  factor.bound = std::numeric_limits<double>::infinity();
  factor.trials = {{0.}, {1.}};
  std::cout << description_of(factor) << std::endl;
}

void acceleration()
{
  // x = M x + b with the eigenvalues 0.9, 0.5 and -0.8.
  Anderson anderson(5);
  std::vector<double> x(3, 0.);
  const double M[] = {0.9, 0.5, -0.8}, b[] = {1., 2., 3.};
  for (unsigned int n = 0; n < 5; ++n)
  {
    std::vector<double> g;
    for (unsigned int i = 0; i < 3; ++i)
      g.push_back(M[i] * x[i] + b[i]);
    x = anderson.next(x, g);
  }
  double error = 0.;
  for (unsigned int i = 0; i < 3; ++i)
    error = std::max(error, std::abs(x[i] - b[i] / (1. - M[i])));
  check_error("three eigenvalues take four steps", error, 1e-9);
}

void run()
{
  states();
  factors();
  scales_and_zero();
  words();
  acceleration();
}

const RoomTest test("coulomb", run);
} // namespace test_coulomb
