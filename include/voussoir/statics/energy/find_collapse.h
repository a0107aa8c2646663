// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_energy_find_collapse_h
#define voussoir_statics_energy_find_collapse_h

#include <voussoir/statics/problem/shared_problem.h>
#include <voussoir/terminal/terminal.h>

#include <optional>

namespace Voussoir
{
/**
 * Look for a proof that the load is not carried, for a solver that has taken
 * many iterations without an answer: by the barrier problem, or if no motion
 * opens all joints by elastic ones, whose displacements grow along a mechanism
 * if there is one. Collective.
 *
 * @return the proof, or none if none was found, or a linear system cannot be
 *   solved, which proves nothing.
 */
std::optional<Mechanism> find_collapse(const SharedProblem &problem,
                                       Terminal &terminal);
} // namespace Voussoir

#endif
