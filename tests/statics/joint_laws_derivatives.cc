// SPDX-License-Identifier: LGPL-2.1-or-later

// The laws of least energy and of the analytic centre: forces are admissible,
// second derivatives those of the forces, and the forces of the barrier those
// that minimise over v the energy b v - w log(v - x) - w log(v + x). The forces
// of a section that yields are sums over thin strips.

#include <voussoir/statics/energy/barrier_joint.h>
#include <voussoir/statics/energy/elastic_problem.h>
#include <voussoir/statics/energy/section.h>

#include "tests.h"
#include <random>
#include <vector>

namespace test_joint_laws_derivatives
{
using namespace Voussoir;

/** Of a joint with one contact: normal, and tangential. */
using Pair = std::vector<double>;

Pair force(const JointLaw &law, const Pair &jumps)
{
  Pair forces(2);
  law.find_forces(0, jumps.data(), forces.data());
  return forces;
}

void check_law(const std::string &name,
               const JointLaw &law,
               const double strength,
               const std::vector<double> &openings)
{
  const double h = 1e-6;
  double second = 0., above = 0.;
  for (const double x : {-30., -1.3, -0.1, 0., 0.3, 2., 1e3})
    for (const double y : openings)
    {
      const Pair jumps = {y, x}, f = force(law, jumps);
      Pair curvature(2);
      law.find_second_derivatives(0, jumps.data(), curvature.data());
      const double normal =
          (force(law, {y + h, x})[0] - force(law, {y - h, x})[0]) / (2. * h);
      const double tangential =
          (force(law, {y, x + h})[1] - force(law, {y, x - h})[1]) / (2. * h);
      second = std::max({second,
                         std::abs(normal - curvature[0]) / (1. + curvature[0]),
                         std::abs(tangential - curvature[1])});
      above = std::max({above, f[0], std::abs(f[1]) - strength});
    }
  check_error(name + ": second derivatives", second, 1e-6);
  check_error(name + ": force above the strength, or tension", above, 0.);
}

/** The largest difference of two sections' forces. */
double distance(const Section::Forces &a, const Section::Forces &b)
{
  return std::max(std::abs(a.at_start - b.at_start),
                  std::abs(a.at_end - b.at_end));
}

void sections()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1., 1.);
  double of_forces = 0., of_stiffness = 0.;
  for (unsigned int k = 0; k < 200; ++k)
  {
    const NormalLimits limits = {0.2 + 0.2 * number(random),
                                 0.6 + 0.5 * number(random)};
    const double stiffness = 1.5 + number(random);
    const Section section(stiffness, limits);
    const double g[] = {number(random), k % 10 == 0 ? 1e-9 : number(random)};
    const Section::Forces found = section.forces(g[0], g[1]);
    Section::Forces sum = {0., 0.};
    const unsigned int n = 4000;
    for (unsigned int i = 0; i < n; ++i)
    {
      const double s = (i + 0.5) / n;
      const double stress = std::clamp(stiffness * ((1. - s) * g[0] + s * g[1]),
                                       -limits.crushing, limits.tension) /
                            n;
      sum.at_start += (1. - s) * stress;
      sum.at_end += s * stress;
    }
    of_forces = std::max(of_forces, distance(found, sum));
    const Section::Stiffness slope = section.stiffness(g[0], g[1]);
    const double h = 1e-6;
    const Section::Forces start = section.forces(g[0] + h, g[1]),
                          end = section.forces(g[0], g[1] + h);
    of_stiffness = std::max({of_stiffness,
                             distance({(start.at_start - found.at_start) / h,
                                       (start.at_end - found.at_end) / h},
                                      {slope.at_start, slope.mixed}),
                             distance({(end.at_start - found.at_start) / h,
                                       (end.at_end - found.at_end) / h},
                                      {slope.mixed, slope.at_end})});
  }
  check_error("forces of a section", of_forces, 1e-6);
  check_error("its stiffness", of_stiffness, 1e-4);
  // All of it is crushed, is torn, or is under one stress.
  const Section whole(2., {0.25, 1.});
  check_error("crushed", distance(whole.forces(-1., -3.), {-0.5, -0.5}), 1e-15);
  check_error("torn", distance(whole.forces(1., 3.), {0.125, 0.125}), 1e-15);
  check_error("even", distance(whole.forces(-0.1, -0.1), {-0.1, -0.1}), 1e-15);
}

void run()
{
  sections();
  const Scene scene =
      scene_under_stress(random_packing(2, 1), 0.7, tensor(-1, 0, 0, -1));
  const DiscreteProblem problem = discretise(scene);
  const double b = problem.joints()[0].strength;

  check_law("elastic", ElasticJoint(problem), b, {-3., -0.2, 0.1, 5.});
  for (const auto weights : {BarrierWeights::equal, BarrierWeights::edge_area})
  {
    BarrierJoint law(problem, weights);
    check_law("barrier", law, b, {1e-2, 0.1, 5.});
    const double w = law.weight(0);
    double p = 0., q = 0., slack = 0.;
    for (const double x : {-100., -2., -0.01, 0., 0.7, 20.})
    {
      p = std::max(p, std::abs(force(law, {0.3, x})[0] * 0.3 / w + 1.));
      // d/dv = 0 gives v, and with it q = w / (v - x) - w / (v + x).
      const double v = (w + std::sqrt(w * w + b * b * x * x)) / b;
      const double expected = w / (v - x) - w / (v + x);
      const double found = force(law, {0.3, x})[1];
      q = std::max(q, std::abs(found - expected));
      slack =
          std::max(slack, std::abs(law.slack(0, x) - (b - std::abs(found))));
    }
    check_error("barrier: p y = w", p, 1e-14);
    check_error("barrier: q at the best v", q, 1e-10);
    check_error("barrier: slack", slack, 1e-14);
    check("barrier: outside, infinite", std::isinf(force(law, {-0.1, 0.})[0]));
    check_error("barrier: step to the boundary",
                std::abs(law.longest_step(0, Pair{0.3, 0.}.data(),
                                          Pair{-0.6, 9.}.data()) -
                         0.5),
                1e-15);

    law.fixed[0] = 1;
    law.fixed[1] = -1;
    check("fixed: p = 0, q = -b", force(law, {-1., 3.}) == Pair{0., -b});
  }
}

const RoomTest test("joint_laws_derivatives", run);
} // namespace test_joint_laws_derivatives
