// SPDX-License-Identifier: LGPL-2.1-or-later

// Samples of all states: those of a block on three feet are a triangle, of
// blocks on two rough feet a box, with Coulomb's friction a rhombus, of blocks
// that turn on one foot a segment, with mean, variance and correlation in
// closed form; standard errors are those of many seeds; the same seed gives the
// same samples on any number of threads; samples lie within the ranges, also
// where these are points; walks that are too short give no mean.

#include <voussoir/analyses/ranges/ranges.h>
#include <voussoir/analyses/sample_analysis.h>
#include <voussoir/analyses/samples/chain_diagnosis.h>
#include <voussoir/base/random.h>

#include <deal.II/base/multithread_info.h>

#include "tests.h"
#include <cmath>

namespace test_samples
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

StateSamples draw(const Scene &scene,
                  const unsigned int n,
                  const unsigned int n_steps = 0,
                  const unsigned int seed = 1)
{
  SamplesWanted wanted;
  wanted.n = n;
  wanted.n_steps = n_steps;
  wanted.seed = seed;
  return draw_samples(scene, wanted, Terminal::silent());
}

/** What a force has in closed form. */
struct Expected
{
  double mean, variance, kurtosis;
};

/** A force has the mean and the variance, within four standard errors. */
void compare(const std::string &name,
             const StateSamples &samples,
             const Moments &found,
             const Expected &expected)
{
  constexpr double four = 4.;
  check("  " + name + ": mean",
        std::abs(found.mean - expected.mean) <= four * found.error);
  check("  " + name + ": variance",
        std::abs(found.deviation * found.deviation / expected.variance - 1.) <=
            four * std::sqrt((expected.kurtosis - 1.) / samples.effective));
  check("  " + name + ": error",
        found.error > 0. && found.error <= 1.001 * found.deviation /
                                               std::sqrt(samples.effective));
}

/** @p n_blocks blocks beside each other, on @p n feet each of width one. */
Packing<2> on_feet(const unsigned int n, const unsigned int n_blocks = 1)
{
  CellLoops loops;
  for (unsigned int b = 0; b < n_blocks; ++b)
  {
    const double left = b * (n + 1.);
    for (unsigned int k = 0; k <= n; ++k)
      loops.vertices.push_back(Point<2>(left + k, 0.));
    loops.vertices.push_back(Point<2>(left + n, 1.));
    loops.vertices.push_back(Point<2>(left, 1.));
    while (loops.loops.size() < loops.vertices.size())
      loops.loops.push_back(loops.loops.size());
    loops.first.push_back(loops.loops.size());
  }
  return on_ground(Packing<2>(loops));
}

/**
 * A smooth block of weight one on three feet: the forces p >= 0 with the sum
 * one are a triangle, and each has the distribution Beta(1, 2).
 */
Scene triangle()
{
  return under_weight(on_feet(3), 0., 0., translations(),
                      Tensor<1, 2>({0., -1. / 3.}));
}
constexpr Expected of_triangle = {-1. / 3., 1. / 18., 2.4};

/** On two rough feet: p_1 + p_2 = 1 and q_1 + q_2 = 0, a box. */
Scene box(const unsigned int n_blocks)
{
  return under_weight(on_feet(2, n_blocks), 0.2, 0., translations(),
                      Tensor<1, 2>({0., -0.5}));
}
constexpr Expected pressure_in_box = {-0.5, 1. / 12., 1.8},
                   friction_in_box = {0., 0.4 * 0.4 / 12., 1.8};

/**
 * With Coulomb's friction |q| <= mu min(p_1, p_2), a rhombus: p has a
 * triangular density about 1/2, and q about 0 with half width 0.3.
 */
Scene rhombus()
{
  return under_weight(on_feet(2), 0., 0.6, translations(),
                      Tensor<1, 2>({0., -0.5}));
}
constexpr Expected pressure_in_rhombus = {-0.5, 1. / 24., 2.4},
                   friction_in_rhombus = {0., 0.09 / 6., 2.4};

/**
 * A smooth block that turns, on two feet with forces at both ends of each: x at
 * 0, y and 1 - 2 x - y at 1, and x at 2 balance its weight and its moment. That
 * is a triangle of x and y with the corners (0, 0), (1/2, 0) and (0, 1), where
 * the first foot has x + y: 0, 1/2 and 1 at the corners, so that its variance
 * is (0 + 1/4 + 1 - 3/4) / 12.
 */
Scene turning_triangle()
{
  return under_weight(on_feet(2), 0., 0., rotations(),
                      Tensor<1, 2>({0., -0.5}));
}
constexpr Expected foot_that_turns = {-0.5, 1. / 24., 2.4};

void closed_forms()
{
  constexpr unsigned int n = 4000;
  StateSamples samples = draw(triangle(), n);
  std::cout << "on three feet" << std::endl;
  check("  a triangle", samples.dimension == 2);
  check("  worth as many", samples.effective >= n && samples.have_settled());
  check_error("  mixing", samples.mixing - 1., 0.01);
  check_error("  balance", samples.error_of_states, 1e-9);
  for (unsigned int e = 0; e < 3; ++e)
  {
    compare("foot " + std::to_string(e), samples, samples.normal[e],
            of_triangle);
    check_error("  no friction",
                std::abs(samples.tangential[e].mean) +
                    samples.tangential[e].deviation,
                0.);
  }

  samples = draw(box(5), n);
  std::cout << "five blocks on two feet" << std::endl;
  check("  a box", samples.dimension == 10);
  compare("pressure", samples, samples.normal[4], pressure_in_box);
  compare("friction", samples, samples.tangential[4], friction_in_box);
  check_error("  independent", std::abs(samples.correlation[4]), 0.07);

  samples = draw(rhombus(), n);
  std::cout << "with Coulomb's friction" << std::endl;
  compare("pressure", samples, samples.normal[0], pressure_in_rhombus);
  compare("friction", samples, samples.tangential[0], friction_in_rhombus);

  samples = draw(turning_triangle(), n);
  std::cout << "a block that turns" << std::endl;
  check("  a triangle", samples.dimension == 2);
  compare("foot", samples, samples.normal[0], foot_that_turns);
}

/** The error of one seed over the standard error that it states. */
double stated_error(const Moments &found, const double mean)
{
  return (found.mean - mean) / found.error;
}

/**
 * Standard errors are honest: over many seeds the errors of the means are as
 * large as they say, in the root of the mean square.
 */
void honest_errors()
{
  constexpr unsigned int n_seeds = 40, n = 400;
  double of_triangles = 0., of_boxes = 0., of_rhombi = 0.;
  bool small = true;
  const auto add = [&small](const double error, double &sum) {
    small &= std::abs(error) < 5.;
    sum += error * error / n_seeds;
  };
  for (unsigned int seed = 1; seed <= n_seeds; ++seed)
  {
    add(stated_error(draw(triangle(), n, 0, seed).normal[0], of_triangle.mean),
        of_triangles);
    add(stated_error(draw(box(3), n, 0, seed).tangential[2],
                     friction_in_box.mean),
        of_boxes);
    add(stated_error(draw(rhombus(), n, 0, seed).normal[1],
                     pressure_in_rhombus.mean),
        of_rhombi);
  }
  // The root of the mean of 40 squares has a standard error of 0.11.
  std::cout << "errors of 40 seeds over the stated ones" << std::endl;
  check_error("  triangle", std::abs(std::sqrt(of_triangles) - 1.), 0.3);
  check_error("  box", std::abs(std::sqrt(of_boxes) - 1.), 0.3);
  check_error("  rhombus", std::abs(std::sqrt(of_rhombi) - 1.), 0.3);
  check("  all within five", small);
}

/** A chain x_k+1 = rho x_k + noise, of variance one. */
std::vector<double>
autoregressive(const double rho, const double mean, const unsigned int seed)
{
  Random random(seed);
  std::vector<double> chain;
  double x = random.normal();
  for (unsigned int k = 0; k < 10000; ++k)
  {
    chain.push_back(mean + x);
    x = rho * x + std::sqrt(1. - rho * rho) * random.normal();
  }
  return chain;
}

/**
 * Diagnosis of chains whose samples t apart have the correlation rho^t, so that
 * n are worth n (1 - rho) / (1 + rho), and of chains that do not agree.
 */
void diagnosis()
{
  std::cout << "diagnosis of chains" << std::endl;
  for (const double rho : {0., 0.5, 0.9, -0.5})
  {
    std::vector<std::vector<double>> chains;
    for (unsigned int c = 0; c < 4; ++c)
      chains.push_back(autoregressive(rho, 7., 100 + c));
    const ChainDiagnosis found = diagnose(chains, 1e-8);
    const double worth = 4. * chains[0].size() * (1. - rho) / (1. + rho);
    std::cout << "  rho = " << rho << std::endl;
    check_error("  effective number", std::abs(found.effective / worth - 1.),
                0.15);
    check_error("  mixing", std::abs(found.mixing - 1.), 0.01);
    check_error("  mean", std::abs(found.mean - 7.), 4. / std::sqrt(worth));
    check_error("  deviation", std::abs(found.deviation - 1.), 0.05);
  }
  std::vector<std::vector<double>> chains;
  for (unsigned int c = 0; c < 4; ++c)
    chains.push_back(autoregressive(0., c, 100 + c));
  const ChainDiagnosis apart = diagnose(chains, 1e-8);
  check("  chains apart: mixing", apart.mixing > 1.5);
  check("  chains apart: effective number", apart.effective < 20.);
  const ChainDiagnosis constant =
      diagnose(std::vector<std::vector<double>>(4, {7., 7., 7., 7.}), 1e-8);
  check("  constant", constant.mean == 7. && constant.error() == 0. &&
                          constant.mixing == 1. && constant.effective == 16.);
}

/** Steps are found by what the walk tells, up to a limit, or are given. */
void steps()
{
  std::cout << "steps between samples" << std::endl;
  Scene scene = under_weight(on_ground(wall(4, 5)), 0., 0.6, translations());
  const StateSamples found = draw(scene, 400);
  check("  more than one", found.n_steps > 1 && !found.is_given);
  check("  worth as many", found.effective >= 400. && found.have_settled());
  SamplesWanted wanted;
  wanted.n = 400;
  wanted.most_steps = 1;
  const StateSamples limited = draw_samples(scene, wanted, Terminal::silent());
  check("  at the limit", limited.n_steps == 1 && !limited.is_given);
  check("  not settled", !limited.have_settled());
  const StateSamples given = draw(scene, 400, 1);
  check("  given", given.n_steps == 1 && given.is_given && given.n == 400);
  check("  not settled", !given.have_settled());
}

/** All states of a block on one foot have the same forces. */
void point()
{
  const Scene scene = under_weight(on_feet(1), 0.2, 0., translations());
  const StateSamples samples = draw(scene, 400);
  check("one state", samples.dimension == 0 && samples.have_settled() &&
                         std::abs(samples.normal[0].mean + 1.) < 1e-12 &&
                         samples.normal[0].deviation == 0. &&
                         samples.normal[0].error == 0.);
}

bool are_equal(const StateSamples &a, const StateSamples &b)
{
  bool equal = true;
  for (unsigned int e = 0; e < a.normal.size(); ++e)
    equal &= a.normal[e].mean == b.normal[e].mean &&
             a.normal[e].deviation == b.normal[e].deviation &&
             a.normal[e].error == b.normal[e].error &&
             a.tangential[e].mean == b.tangential[e].mean &&
             a.correlation[e] == b.correlation[e];
  return equal;
}

void seeds()
{
  const Scene scene =
      under_weight(on_ground(wall(3, 3)), 0.5, 0., translations());
  const StateSamples first = draw(scene, 100);
  dealii::MultithreadInfo::set_thread_limit(1);
  const StateSamples alone = draw(scene, 100);
  dealii::MultithreadInfo::set_thread_limit();
  check("the same seed on one thread", are_equal(first, alone));
  check("another seed", !are_equal(first, draw(scene, 100, 0, 2)));
}

/** Samples lie within the ranges, also where some are points. */
void within_ranges()
{
  for (const Kinematics *kinematics : {&translations(), &rotations()})
    for (const double mu : {0., 0.5})
    {
      Scene scene =
          under_weight(on_ground(random_packing(20, 7)), 0.3, mu, *kinematics);
      const StateSamples samples = draw(scene, 400);
      const Ranges ranges = find_ranges(
          scene, {std::vector<bool>(scene.strength.size(), true), false},
          Terminal::silent());
      bool within = true, points = true;
      unsigned int n_determined = 0;
      const double error = 1e-7 * ranges.reference;
      const auto look = [&](const Range &range, const Moments &found) {
        within &= range.least - error <= found.mean &&
                  found.mean <= range.greatest + error &&
                  found.deviation <= range.greatest - range.least + error;
        if (range.greatest - range.least > 1e-3 * ranges.reference)
          points &= found.deviation > 0.;
        else if (ranges.is_determined(range))
          ++n_determined;
      };
      for (unsigned int e = 0; e < ranges.normal.size(); ++e)
      {
        look(ranges.normal[e], samples.normal[e]);
        look(ranges.tangential[e], samples.tangential[e]);
      }
      std::cout << "20 cells, " << kinematics->name()
                << (mu > 0. ? ", Coulomb" : ", Tresca")
                << ", determined: " << n_determined << std::endl;
      check("  within their ranges", within);
      check("  with a spread where these are no points", points);
      check_error("  balance", samples.error_of_states, 1e-9);
    }
}

void refusals()
{
  Packing<2> packing = wall(1, 1);
  std::vector<bool> rests;
  for (const auto &edge : packing.boundary_edges())
    rests.push_back(edge.normal[1] < 0.5);
  packing.support(rests);
  Scene clamped = under_weight(packing, 0.2, 0., translations());
  show_refusal([&] { draw(clamped, 100); });
  clamped.tensile_strength.assign(clamped.strength.size(), 1.);
  show_refusal([&] { draw(clamped, 100); });
  show_refusal([] {
    draw(under_weight(on_ground(wall(45, 45)), 1., 0., translations()), 100);
  });
  // Pushed as hard as its friction resists, at whatever share of each foot.
  Scene sliding = rhombus();
  sliding.load[0] = Tensor<1, 2>({0.6, -1.});
  try
  {
    draw(sliding, 100);
    check("a refusal", false);
  }
  catch (const SolverError &error)
  {
    std::cout << error.what() << std::endl;
  }
  SampleAnalysis parameters;
  dealii::ParameterHandler prm;
  parameters.add_parameters(prm);
  check("none by default", !parameters.wanted());
  prm.enter_subsection("Ranges");
  prm.set("Samples", 5L);
  prm.leave_subsection();
  show_refusal([&] { parameters.wanted(); });
}

void run()
{
  closed_forms();
  honest_errors();
  diagnosis();
  steps();
  point();
  seeds();
  within_ranges();
  refusals();
}

const RoomTest test("samples", run);
} // namespace test_samples
