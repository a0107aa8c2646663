// SPDX-License-Identifier: LGPL-2.1-or-later

// The laws of least energy and of the analytic centre: forces are admissible,
// second derivatives those of the forces, and the forces of the barrier those
// that minimise over v the energy b v - w log(v - x) - w log(v + x).

#include <voussoir/statics/barrier_joint.h>
#include <voussoir/statics/elastic_problem.h>

#include "tests.h"

using namespace Voussoir;
using Jump = JointLaw::Jump;

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
      const Jump force = law.force(0, {y, x});
      const Jump curvature = law.second_derivative(0, {y, x});
      const double normal =
          (law.force(0, {y + h, x}).normal - law.force(0, {y - h, x}).normal) /
          (2. * h);
      const double tangential = (law.force(0, {y, x + h}).tangential -
                                 law.force(0, {y, x - h}).tangential) /
                                (2. * h);
      second = std::max(
          {second,
           std::abs(normal - curvature.normal) / (1. + curvature.normal),
           std::abs(tangential - curvature.tangential)});
      above = std::max(
          {above, force.normal, std::abs(force.tangential) - strength});
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
      p = std::max(p, std::abs(law.force(0, {0.3, x}).normal * 0.3 / w + 1.));
      // d/dv = 0 gives v, and with it q = w / (v - x) - w / (v + x).
      const double v = (w + std::sqrt(w * w + b * b * x * x)) / b;
      const double expected = w / (v - x) - w / (v + x);
      const double found = law.force(0, {0.3, x}).tangential;
      q = std::max(q, std::abs(found - expected));
      slack = std::max(
          slack, std::abs(law.slack(0, {0.3, x}) - (b - std::abs(found))));
    }
    check_error("barrier: p y = w", p, 1e-14);
    check_error("barrier: q at the best v", q, 1e-10);
    check_error("barrier: slack", slack, 1e-14);
    check("barrier: outside, infinite",
          std::isinf(law.force(0, {-0.1, 0.}).normal));
    check_error("barrier: step to the boundary",
                std::abs(law.longest_step(0, {0.3, 0.}, {-0.6, 9.}) - 0.5),
                1e-15);

    law.fixed[0] = {true, -1};
    check("fixed: p = 0, q = -b", law.force(0, {-1., 3.}).normal == 0. &&
                                      law.force(0, {-1., 3.}).tangential == -b);
  }
}
