// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_factors_check_strength_factor_h
#define voussoir_analyses_factors_check_strength_factor_h

#include <voussoir/analyses/factors/load_factor.h>

namespace Voussoir
{
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
