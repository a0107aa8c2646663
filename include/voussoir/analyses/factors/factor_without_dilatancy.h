// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_factors_factor_without_dilatancy_h
#define voussoir_analyses_factors_factor_without_dilatancy_h

#include <voussoir/analyses/factors/load_factor.h>
#include <voussoir/statics/energy/coulomb_state.h>

namespace Voussoir
{
/**
 * Find a factor at which the loads are carried, and blocks that slide without
 * lifting collapse: that of find_collapse_pair(), from the forces at the factor
 * of associated friction. States of CoulombState are looked for at shares of
 * it, and between it and the factor of associated friction, beyond which there
 * is nothing to be found: forces that friction admits are the same whether
 * blocks dilate or not. Where one of these has a state, or no collapse is
 * found, it is the greatest factor with a state among those that are tried, the
 * last of them by bisection.
 *
 * A state proves nothing but itself: no theorem says that such loads cannot
 * move the blocks, that a greater factor has no other state, or that a smaller
 * one has any. LoadFactor::trials says which factors were tried.
 *
 * @param dead the scene with the dead loads, with a coefficient of friction, in
 *   the plane or in space.
 * @param live the same scene with the live loads instead.
 * @param formulation selects the states.
 * @param controls of both methods.
 * @param factor_controls of the search for the bound.
 * @param terminal sees the iterations.
 * @return LoadFactor::bound by the associated friction, and its mechanism, if
 *   there is none of LoadFactor::own_collapse; if LoadFactor::trials is empty,
 *   all of it, since there was nothing to try.
 * @throws InputError, SolverError as find_load_factor() does, or if there is no
 *   state at all.
 */
template <typename SceneOf>
FactorAnswerOf<SceneOf>
find_factor_without_dilatancy(const SceneOf &dead,
                              const SceneOf &live,
                              const CoulombState &formulation,
                              const SolverControls &controls,
                              const LoadFactorControls &factor_controls,
                              Terminal &terminal);
} // namespace Voussoir

#endif
