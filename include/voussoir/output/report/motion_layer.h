// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_motion_layer_h
#define voussoir_output_report_motion_layer_h

#include <voussoir/output/report/drawing.h>
#include <voussoir/scene/motion.h>
#include <voussoir/scene/scene.h>

#include <string>

namespace Voussoir
{
/**
 * Draw blocks in their moved places, the joints that open, turn about an end or
 * slide, and links. For the script of a page each joint has its number as
 * `data-joint`, and the cells that it and each link move with stand in
 * `data-cells`, -1 for the ground; blocks are in the order of their numbers.
 *
 * @param factor of the motion.
 * @param views that show it.
 */
void draw_motion(Drawing &drawing,
                 const Scene &scene,
                 const Motion &motion,
                 double factor,
                 const std::string &views);
} // namespace Voussoir

#endif
