// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_factors_changed_strengths_h
#define voussoir_analyses_factors_changed_strengths_h

#include <voussoir/scene/scene.h>
#include <voussoir/scene/space/space_scene.h>

namespace Voussoir
{
/** @{ */
/** @p scene with its strengths against sliding, s_T or c and mu, divided. */
Scene with_strengths_divided(const Scene &scene, double divisor);
SpaceScene with_strengths_divided(const SpaceScene &scene, double divisor);
/** @} */

/** @{ */
/** A scene whose finite strengths are no larger than @p most; S. */
Scene with_strengths_up_to(Scene scene, double most);
SpaceScene with_strengths_up_to(SpaceScene scene, double most);
/** @} */
} // namespace Voussoir

#endif
