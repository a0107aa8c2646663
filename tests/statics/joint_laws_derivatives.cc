// SPDX-License-Identifier: LGPL-2.1-or-later

// The laws of least energy and of the analytic centre: forces are admissible,
// second derivatives those of the forces, and the forces of the barrier those
// that minimise over v the energy b v - w log(v - x) - w log(v + x).

#include <voussoir/statics/barrier_joint.h>
#include <voussoir/statics/elastic_problem.h>

#include "tests.h"
#include <vector>

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

int main()
{
  const Scene scene =
      scene_under_stress(random_packing(2, 1), 0.7, tensor(-1, 0, 0, -1));
  const DiscreteProblem problem(scene);
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
