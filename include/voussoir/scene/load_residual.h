// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_load_residual_h
#define voussoir_scene_load_residual_h

#include <voussoir/scene/scene.h>

namespace Voussoir
{
/**
 * How far the loads that act differ from those that were asked for: the sums of
 * the forces on edges and in cells, and of F_c and its torques, less
 * Scene::requested, over the sum of the sizes of the loads; and those of the
 * moments, over that times the diagonal of the packing, whichever is most. Zero
 * where nothing is known of what was asked for.
 */
double load_residual(const Scene &scene);

/**
 * The largest load_residual() of a result: what is left where the places of
 * loads are written with few digits, up to a millionth of a cell or a line from
 * where they act.
 */
constexpr double largest_load_residual = 1e-5;
} // namespace Voussoir

#endif
