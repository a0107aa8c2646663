// SPDX-License-Identifier: LGPL-2.1-or-later

// The energy of a smoothed joint: its derivatives against differences, its
// bounds, and its value far below and far above the smoothing length, where
// sqrt(x^2 + eps^2) - eps cancels or is |x| - eps.

#include <voussoir/statics/paper/smoothed_joint.h>

#include "tests.h"
#include <vector>

namespace test_smoothed_joint_derivatives
{
using namespace Voussoir;

/** Of a joint with one contact: normal, and tangential. */
using Pair = std::vector<double>;

Pair force_of(const SmoothedJoint &law, const Pair &jumps)
{
  Pair forces(2);
  law.find_forces(0, jumps.data(), forces.data());
  return forces;
}

Pair curvature_of(const SmoothedJoint &law, const Pair &jumps)
{
  Pair second(2);
  law.find_second_derivatives(0, jumps.data(), second.data());
  return second;
}

void run()
{
  const Scene scene =
      scene_under_stress(random_packing(2, 1), 0.7, tensor(-1, 0, 0, -1));
  const DiscreteProblem problem = discretise(scene);
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
        const auto difference = [&](const auto &f, const double dy,
                                    const double dx) {
          return (f({y + dy, x + dx}) - f({y - dy, x - dx})) / (2. * h);
        };
        const auto energy = [&](const Pair &jumps) {
          return law.energy(0, jumps.data());
        };
        const auto normal = [&](const Pair &jumps) {
          return force_of(law, jumps)[0];
        };
        const auto tangential = [&](const Pair &jumps) {
          return force_of(law, jumps)[1];
        };
        const Pair force = force_of(law, {y, x});
        const Pair curvature = curvature_of(law, {y, x});
        first = std::max({first, std::abs(difference(energy, h, 0.) - force[0]),
                          std::abs(difference(energy, 0., h) - force[1])});
        second = std::max(
            {second, std::abs(difference(normal, h, 0.) - curvature[0]),
             std::abs(difference(tangential, 0., h) - curvature[1])});
        above =
            std::max({above, force[0], std::abs(force[1]) - joint.strength});
      }
    check_error("  first derivatives", first, 1e-6);
    check_error("  second derivatives", second, 1e-6);
    check_error("  force above the strength, or tension", above, 0.);

    // h(x) = x^2 / (2 eps) for small x, with the curvature s_e |e| / eps.
    const double small = 1e-9;
    const double eps = joint.strength / curvature_of(law, {1., 0.})[1];
    check_error("  energy of a tiny slip, relative",
                std::abs(law.energy(0, Pair{1., small}.data()) * 2. * eps /
                             (joint.strength * small * small) -
                         1.),
                1e-12);
    check_error("  energy of a large slip, relative",
                std::abs(law.energy(0, Pair{1., 1e12}.data()) /
                             (joint.strength * (1e12 - eps)) -
                         1.),
                1e-12);
  }
}

const RoomTest test("smoothed_joint_derivatives", run);
} // namespace test_smoothed_joint_derivatives
