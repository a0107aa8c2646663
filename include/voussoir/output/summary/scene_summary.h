// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_summary_scene_summary_h
#define voussoir_output_summary_scene_summary_h

#include <voussoir/output/report/details.h>
#include <voussoir/scene/scene.h>
#include <voussoir/terminal/terminal.h>

#include <string>

namespace Voussoir
{
/**
 * Show what a scene was understood to be, for people to compare with what they
 * meant: units, the cells of each group with their areas and weights, the
 * joints of each pair of groups with their strengths, and the tractions.
 */
void show_scene(Terminal &terminal, const Scene &scene, const UnitNames &units);

/** The law of friction, and what it means for what is carried. */
std::string description_of_law(const Scene &scene);
} // namespace Voussoir

#endif
