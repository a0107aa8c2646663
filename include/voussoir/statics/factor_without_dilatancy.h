// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_factor_without_dilatancy_h
#define voussoir_statics_factor_without_dilatancy_h

#include <voussoir/statics/coulomb_state.h>
#include <voussoir/statics/load_factor.h>

namespace Voussoir
{
/**
 * Find the factor up to which CoulombState has a state, by bisection between
 * zero, or one, and the factor of associated friction, which bounds it: forces
 * that friction admits are the same whether blocks dilate or not.
 *
 * The state is a proof of nothing but itself: no theorem says that such loads
 * cannot move the blocks, or that a greater factor has no other state.
 *
 * @param dead the scene with the dead loads, with a coefficient of friction.
 * @param live the same scene with the live loads instead.
 * @param formulation selects the states.
 * @param controls of both methods.
 * @param factor_controls of the search for the bound.
 * @param terminal sees the iterations.
 * @return LoadFactor::bound and its mechanism by the associated friction.
 * @throws InputError, SolverError as find_load_factor() does, or if there is no
 *   state at all.
 */
LoadFactorAnswer
find_factor_without_dilatancy(const Scene &dead,
                              const Scene &live,
                              const CoulombState &formulation,
                              const SolverControls &controls,
                              const LoadFactorControls &factor_controls,
                              Terminal &terminal);
} // namespace Voussoir

#endif
