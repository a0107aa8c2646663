// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_stress_part_h
#define voussoir_stress_stress_part_h

#include <voussoir/parallel/process_group.h>
#include <voussoir/scene/motion.h>
#include <voussoir/stress/reconstruction.h>
#include <voussoir/terminal/terminal.h>

#include <vector>

namespace Voussoir
{
/**
 * The cells of one process, cut free of all others, and the stress inside them.
 * The processes have cells that follow each other in number, as many as
 * possible the same.
 */
struct StressPart
{
  /** The number of its first cell in the whole packing. */
  unsigned int first_cell;
  /** Its cells, numbered from 0, with boundary edges only; see cut_free(). */
  Packing<2> packing;
  /** The motion of each of them; L. */
  Motion motion;
  /** The stress in them; but see reconstruct_on_root(). */
  StressField stress;
};

/**
 * Find the stress in all cells of a scene, of which the root has the whole: it
 * sends each process its cells and the forces on them. Collective.
 *
 * @return the part of this process, in which undetermined cells have their
 *   numbers in the whole packing; on the root the list of these and the number
 *   of sub-cells are those of all processes.
 */
StressPart reconstruct_on_root(const Scene &scene,
                               const InterfaceForces &forces,
                               const Motion &motion,
                               const Reconstruction &how,
                               const ProcessGroup &processes,
                               Terminal &terminal);

/** The name of this task, to which the root calls; see ProcessGroup::call(). */
inline const std::string stress_task = "stress";

/** The part of another process than the root. */
StressPart work_on_stress(const ProcessGroup &processes, Terminal &terminal);
} // namespace Voussoir

#endif
