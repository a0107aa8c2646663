// SPDX-License-Identifier: LGPL-2.1-or-later

// The energy of a smoothed joint: its derivatives against differences, its
// bounds, and its value far below and far above the smoothing length, where
// sqrt(x^2 + eps^2) - eps cancels or is |x| - eps.

#include <voussoir/statics/smoothed_joint.h>

#include "tests.h"

using namespace Voussoir;

int main()
{
  const Scene scene =
      scene_under_stress(random_packing(2, 1), 0.7, tensor(-1, 0, 0, -1));
  const DiscreteProblem problem(scene);
  const auto &joint = problem.joints()[0];

  for (const Contact contact : {Contact::compliant, Contact::hard})
  {
    const SmoothedJoint law(problem, contact);
    std::cout << (contact == Contact::hard ? "hard" : "compliant") << std::endl;
    double first = 0., second = 0., above = 0.;
    const double h = 1e-5;
    for (const double x : {-30., -1., -0.1, 0., 0.3, 2., 1e3})
      for (const double y : {-3., -0.2, 0.1, 5.})
      {
        const auto force = law.force(0, {y, x});
        const auto curvature = law.second_derivative(0, {y, x});
        const auto difference = [&](const auto &f, const double dy,
                                    const double dx) {
          return (f({y + dy, x + dx}) - f({y - dy, x - dx})) / (2. * h);
        };
        const auto energy = [&](const DiscreteProblem::Jump &jump) {
          return law.energy(0, jump);
        };
        const auto normal = [&](const DiscreteProblem::Jump &jump) {
          return law.force(0, jump).normal;
        };
        const auto tangential = [&](const DiscreteProblem::Jump &jump) {
          return law.force(0, jump).tangential;
        };
        first =
            std::max({first, std::abs(difference(energy, h, 0.) - force.normal),
                      std::abs(difference(energy, 0., h) - force.tangential)});
        second = std::max(
            {second, std::abs(difference(normal, h, 0.) - curvature.normal),
             std::abs(difference(tangential, 0., h) - curvature.tangential)});
        above = std::max(
            {above, force.normal, std::abs(force.tangential) - joint.strength});
      }
    check_error("  first derivatives", first, 1e-6);
    check_error("  second derivatives", second, 1e-6);
    check_error("  force above the strength, or tension", above, 0.);

    // h(x) = x^2 / (2 eps) for small x, with the curvature s_e |e| / eps.
    const double small = 1e-9;
    const double eps =
        joint.strength / law.second_derivative(0, {1., 0.}).tangential;
    check_error("  energy of a tiny slip, relative",
                std::abs(law.energy(0, {1., small}) * 2. * eps /
                             (joint.strength * small * small) -
                         1.),
                1e-12);
    check_error(
        "  energy of a large slip, relative",
        std::abs(law.energy(0, {1., 1e12}) / (joint.strength * (1e12 - eps)) -
                 1.),
        1e-12);
  }
}
