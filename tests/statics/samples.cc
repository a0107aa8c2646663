// SPDX-License-Identifier: LGPL-2.1-or-later

// Samples of all states: those of a block on three feet are a triangle, on two
// rough feet a rectangle or a rhombus, with mean, variance and correlation in
// closed form; the same seed gives the same samples on any number of threads;
// samples lie within the ranges, also where these are points.

#include <voussoir/statics/ranges.h>
#include <voussoir/statics/state_samples.h>

#include <deal.II/base/multithread_info.h>

#include "tests.h"

using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

constexpr double three = 3.;

StateSamples draw(const Scene &scene,
                  const unsigned int n,
                  const unsigned int n_steps,
                  const unsigned int seed = 1)
{
  SamplesWanted wanted;
  wanted.n = n;
  wanted.n_steps = n_steps;
  wanted.seed = seed;
  return draw_samples(scene, wanted, Terminal::silent());
}

/** A force has the mean and the variance, within three standard errors. */
void compare(const std::string &name,
             const Moments &found,
             const double mean,
             const double variance,
             const double kurtosis,
             const unsigned int n)
{
  check_error("  " + name + ": mean", std::abs(found.mean - mean),
              three * std::sqrt(variance / n));
  check_error("  " + name + ": variance",
              std::abs(found.deviation * found.deviation - variance),
              three * variance * std::sqrt((kurtosis - 1.) / n));
}

/** A block on @p n feet, each of width one. */
Packing on_feet(const unsigned int n)
{
  CellLoops loops;
  for (unsigned int k = 0; k <= n; ++k)
    loops.vertices.push_back(Point<2>(k, 0.));
  loops.vertices.push_back(Point<2>(n, 1.));
  loops.vertices.push_back(Point<2>(0., 1.));
  for (unsigned int k = 0; k < loops.vertices.size(); ++k)
    loops.loops.push_back(k);
  loops.first.push_back(loops.loops.size());
  return on_ground(Packing(loops));
}

/**
 * A smooth block of weight one on three feet: the forces p >= 0 with the sum
 * one are a triangle, and each has the distribution Beta(1, 2).
 */
void on_three_feet()
{
  std::cout << "on three feet" << std::endl;
  const Scene scene = under_weight(on_feet(3), 0., 0., translations(),
                                   Tensor<1, 2>({0., -1. / 3.}));
  const unsigned int n = 20000;
  const StateSamples samples = draw(scene, n, 20);
  check("  a triangle", samples.dimension == 2);
  check_error("  mixing", samples.mixing - 1., 0.01);
  check_error("  balance", samples.error_of_states, 1e-9);
  for (unsigned int e = 0; e < 3; ++e)
  {
    compare("foot " + std::to_string(e), samples.normal[e], -1. / 3., 1. / 18.,
            2.4, n);
    check_error("  no friction",
                std::abs(samples.tangential[e].mean) +
                    samples.tangential[e].deviation,
                0.);
  }
}

/**
 * On two rough feet: p_1 + p_2 = 1 and q_1 + q_2 = 0, a rectangle. With
 * Coulomb's friction |q| <= mu min(p_1, p_2), a rhombus.
 */
void on_two_feet()
{
  std::cout << "on two feet" << std::endl;
  const Scene scene = under_weight(on_feet(2), 0.2, 0., translations(),
                                   Tensor<1, 2>({0., -0.5}));
  const unsigned int n = 20000;
  const StateSamples samples = draw(scene, n, 20);
  check("  a rectangle", samples.dimension == 2);
  compare("pressure", samples.normal[0], -0.5, 1. / 12., 1.8, n);
  compare("friction", samples.tangential[0], 0., 0.4 * 0.4 / 12., 1.8, n);
  check_error("  independent", std::abs(samples.correlation[0]),
              three / std::sqrt(n));

  Scene coulomb = scene;
  coulomb.strength.assign(coulomb.strength.size(), 0.);
  coulomb.coefficient.assign(coulomb.strength.size(), 0.6);
  const StateSamples of_rhombus = draw(coulomb, n, 20);
  std::cout << "with Coulomb's friction" << std::endl;
  // p has a triangular density about 1/2, and q about 0 with half width 0.3.
  compare("pressure", of_rhombus.normal[0], -0.5, 1. / 24., 2.4, n);
  compare("friction", of_rhombus.tangential[0], 0., 0.09 / 6., 2.4, n);
}

bool are_equal(const StateSamples &a, const StateSamples &b)
{
  bool equal = true;
  for (unsigned int e = 0; e < a.normal.size(); ++e)
    equal &= a.normal[e].mean == b.normal[e].mean &&
             a.normal[e].deviation == b.normal[e].deviation &&
             a.tangential[e].mean == b.tangential[e].mean &&
             a.correlation[e] == b.correlation[e];
  return equal;
}

void seeds()
{
  const Scene scene =
      under_weight(on_ground(wall(3, 3)), 0.5, 0., translations());
  const StateSamples first = draw(scene, 100, 5);
  dealii::MultithreadInfo::set_thread_limit(1);
  const StateSamples alone = draw(scene, 100, 5);
  dealii::MultithreadInfo::set_thread_limit();
  check("the same seed on one thread", are_equal(first, alone));
  check("another seed", !are_equal(first, draw(scene, 100, 5, 2)));
}

/** Samples lie within the ranges, also where some are points. */
void within_ranges()
{
  for (const Kinematics *kinematics : {&translations(), &rotations()})
    for (const double mu : {0., 0.5})
    {
      Scene scene =
          under_weight(on_ground(random_packing(20, 7)), 0.3, mu, *kinematics);
      const StateSamples samples = draw(scene, 400, 0);
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
  Packing packing = wall(1, 1);
  std::vector<bool> rests;
  for (const auto &edge : packing.boundary_edges())
    rests.push_back(edge.normal[1] < 0.5);
  packing.support(rests);
  Scene clamped = under_weight(packing, 0.2, 0., translations());
  show_refusal([&] { draw(clamped, 100, 0); });
  clamped.tensile_strength.assign(clamped.strength.size(), 1.);
  show_refusal([&] { draw(clamped, 100, 0); });
  RangeParameters parameters;
  dealii::ParameterHandler prm;
  parameters.add_parameters(prm);
  check("none by default", !parameters.samples());
  prm.enter_subsection("Ranges");
  prm.set("Samples", 5L);
  prm.leave_subsection();
  show_refusal([&] { parameters.samples(); });
}

int main()
{
  on_three_feet();
  on_two_feet();
  seeds();
  within_ranges();
  refusals();
}
