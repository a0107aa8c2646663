// SPDX-License-Identifier: LGPL-2.1-or-later

// Without supports the loads must balance on every connected group of cells.

#include "tests.h"

namespace test_scene_balance
{
using namespace Voussoir;

using Vector = dealii::Tensor<1, 2>;

void run()
{
  // Forces whose squares are beyond the numbers are refused, not lost.
  for (const double size : {1e160, 1e-170})
    show_refusal([&] {
      scene_under_stress(random_packing(3, 1), 1, size * tensor(-1, 0, 0, -1));
    });
  // What balance leaves to a cell by itself is rounding.
  const Scene alone =
      scene_with(random_packing(1, 1), 1,
                 [](const dealii::Point<2> &x, const dealii::Tensor<1, 2> &n) {
                   return -(1. + 1e-12 * x[0]) * n;
                 });
  check("a cell by itself carries nothing", alone.load[0].norm() == 0.);

  show_refusal([] {
    scene_with(wall(2, 3), 1., [](const dealii::Point<2> &, const Vector &n) {
      Vector g;
      g[1] = n[1] > 0.5 ? -1. : 0.;
      return g;
    });
  });

  // Two squares that touch in a point, pushed apart: balanced as a whole, but
  // not each.
  CellLoops corner;
  corner.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}, {2, 2}, {1, 2}};
  corner.loops = {0, 1, 2, 3, 2, 4, 5, 6};
  corner.first = {0, 4, 8};
  show_refusal([&] {
    scene_with(Packing<2>(corner), 1.,
               [](const dealii::Point<2> &x, const Vector &n) {
                 Vector g;
                 if (std::abs(n[0]) > 0.5)
                   g[0] = x[1] < 1. ? -1. : 1.;
                 return g;
               });
  });

  // Forces that cancel on every cell are no load, whatever rounding leaves.
  const Scene cancelled = scene_with(
      wall(1, 4, 2., 0.3), 0., [](const dealii::Point<2> &x, const Vector &n) {
        Vector g;
        g[1] = -n[1] * (2. + std::sin(3. * x[0]));
        return g;
      });
  check("no load is left", !discretise(cancelled).is_loaded());

  // Under pressure each is balanced by itself, and no force is needed.
  const Scene scene =
      scene_under_stress(Packing<2>(corner), 1., tensor(-1, 0, 0, -1));
  const InterfaceForces forces = Solver(compliant).forces(scene);
  check("two groups under pressure", forces.normal.empty());
  check_error("their certificate", certify(scene, forces).equilibrium_residual,
              1e-15);
}

const RoomTest test("scene_balance", run);
} // namespace test_scene_balance
