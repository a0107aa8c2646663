// SPDX-License-Identifier: LGPL-2.1-or-later

// A wall and a load that are symmetric about x = 1/2 get symmetric forces from
// every formulation but the linear program, of which nothing is asked.

#include "tests.h"

namespace test_formulations_symmetry
{
using namespace Voussoir;

void run()
{
  const Scene scene =
      scene_with(wall(9, 5), 0.6,
                 [](const dealii::Point<2> &x, const dealii::Tensor<1, 2> &n) {
                   // More in the middle of the top; the cosine has no sum over
                   // its bricks.
                   dealii::Tensor<1, 2> g = -n;
                   if (x[1] > 0.5)
                     g[1] *=
                         1. - 0.5 * std::cos(2. * dealii::numbers::PI * x[0]);
                   return g;
                 });
  const auto &interfaces = scene.packing.interfaces();

  // The mirror image of each interface.
  std::vector<unsigned int> image(interfaces.size(), interfaces.size());
  for (unsigned int e = 0; e < interfaces.size(); ++e)
    for (unsigned int k = 0; k < interfaces.size(); ++k)
    {
      const dealii::Point<2> x = interfaces[k].midpoint();
      if (interfaces[e].midpoint().distance({1. - x[0], x[1]}) < 1e-12)
        image[e] = k;
    }

  for (const Method &method : all_methods)
  {
    if (method.name == linear_program.name)
      continue;
    const InterfaceForces forces = Solver(method).forces(scene);
    double error = 0., least = 0., most = -1e300;
    for (unsigned int e = 0; e < interfaces.size(); ++e)
    {
      // Mirrored, normal and tangential traction keep their size; the force on
      // c- of a head joint comes from the other side.
      const auto f = forces.on_cell_minus(interfaces[e], e);
      auto g = forces.on_cell_minus(interfaces[image[e]], image[e]);
      g[0] *= -1.;
      if (std::abs(interfaces[e].normal[0]) > 0.5)
        g *= -1.;
      error = std::max(error, (f - g).norm());
      least = std::min(least, forces.normal[e]);
      most = std::max(most, forces.normal[e]);
    }
    check_error(method.name + ": asymmetry", error, 1e-8);
    check(method.name + ": forces differ", most - least > 0.05);
  }
}

const RoomTest test("formulations_symmetry", run);
} // namespace test_formulations_symmetry
