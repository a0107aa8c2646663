// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_factors_strength_factor_h
#define voussoir_analyses_factors_strength_factor_h

#include <voussoir/analyses/factors/changed_strengths.h>
#include <voussoir/analyses/factors/check_strength_factor.h>

namespace Voussoir
{
/**
 * Find the greatest number by which the strengths against sliding may be
 * divided. What is carried with some strengths is so with greater ones, and
 * what collapses with some does so with smaller ones: it is found by
 * Newton's method, each end with its proof.
 *
 * @return LoadFactor::carried with forces for the strengths divided by it, and
 *   LoadFactor::bound with a mechanism for the strengths divided by that; or
 *   the collapse of @p scene, if no strengths carry its loads.
 * @param scene with loads, in the plane or in space; its blocks dilate.
 * @param controls of the search.
 * @param terminal sees the iterations.
 * @throws SolverError if there is no proof of anything.
 */
template <typename SceneOf>
FactorAnswerOf<SceneOf> find_strength_factor(const SceneOf &scene,
                                             const LoadFactorControls &controls,
                                             Terminal &terminal);
} // namespace Voussoir

#endif
