// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_factors_divided_strengths_h
#define voussoir_analyses_factors_divided_strengths_h

#include <voussoir/analyses/factors/load_factor.h>

namespace Voussoir
{
/** @{ */
/** @p scene with its strengths against sliding, s_T or c and mu, divided. */
Scene with_strengths_divided(const Scene &scene, double divisor);
SpaceScene with_strengths_divided(const SpaceScene &scene, double divisor);
/** @} */

/**
 * Look whether a strength factor may be asked for.
 *
 * @throws InputError if the least number is asked for, without loads, or if
 *   blocks do not dilate.
 */
template <typename SceneOf>
void check_strength_factor(const SceneOf &scene,
                           const LoadFactorControls &controls);
} // namespace Voussoir

#endif
