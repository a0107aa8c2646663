// SPDX-License-Identifier: LGPL-2.1-or-later

// Trilinos' multigrid gives the forces of the direct solver, for a load that
// one linear solve settles and for one under which joints slide and open; where
// blocks turn as well.

#include <voussoir/parallel/begin_mpi.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/multithread_info.h>

#include "tests.h"

using namespace Voussoir;

int main()
{
  begin_mpi();
  dealii::MultithreadInfo::set_thread_limit(1);
  for (const auto &[d, kinematics] :
       {std::pair(0.2, &translations()), std::pair(0.5, &translations()),
        std::pair(0.2, &rotations()), std::pair(0.35, &rotations())})
  {
    const Scene scene =
        scene_under_stress(random_packing(2000, 1), 0.3,
                           tensor(-1 + d, 0, 0, -1 - d), *kinematics);
    const InterfaceForces direct =
        Solver(least_energy.with("set Linear solver = direct")).forces(scene);
    const InterfaceForces multigrid =
        Solver(least_energy.with("set Linear solver = multigrid"))
            .forces(scene);
    check_error("distance of the forces", distance(direct, multigrid), 1e-9);
    check_error("equilibrium", certify(scene, multigrid).error(), 1e-8);
  }
}
