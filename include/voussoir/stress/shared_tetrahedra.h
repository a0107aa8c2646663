// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_shared_tetrahedra_h
#define voussoir_stress_shared_tetrahedra_h

#include <voussoir/parallel/process_group.h>
#include <voussoir/stress/tetrahedral_stress.h>

#include <string>
#include <vector>

namespace Voussoir
{
/**
 * tetrahedral_stress() by all processes: on the root, which has the scene, and
 * then the stress in all cells. Each process has cells that follow each other
 * in number, as many as the others.
 */
TetrahedralStress
tetrahedral_stress(const SpaceScene &scene,
                   const FaceForces &forces,
                   const std::vector<dealii::Tensor<2, 3>> &means,
                   const ProcessGroup &processes);

/** The name of this task, to which the root calls; see ProcessGroup::call(). */
inline const std::string tetrahedra_task = "tetrahedra";

/** The part of another process than the root. */
void work_on_tetrahedra(const ProcessGroup &processes);
} // namespace Voussoir

#endif
