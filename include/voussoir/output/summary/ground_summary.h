// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_summary_ground_summary_h
#define voussoir_output_summary_ground_summary_h

#include <voussoir/output/results.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/tensor.h>

#include <nlohmann/json.hpp>

#include <string>

namespace Voussoir
{
/** The sum of all loads and, with supports, what it is over their length. */
nlohmann::ordered_json loads_summary(const Scene &scene);

/** The loads, and what the ground does about them. */
nlohmann::ordered_json ground_summary(const Results &results);

/** The interfaces of which the most of the strength is used, at most ten. */
nlohmann::ordered_json most_used_summary(const Results &results);

/** "(0, -5)": components that are rounding beside @p largest are 0. */
std::string text_of_force(const dealii::Tensor<1, 2> &force, double largest);

/** A line on the loads of a packing with supports, by @p name. */
void show_loads(Terminal &terminal,
                const Scene &scene,
                const std::string &name = "Loads");

/** A line on all reactions, and one on each straight support if it has several.
 */
void show_reactions(Terminal &terminal, const Results &results);

/** Lines on the interfaces of which the most of the strength is used. */
void show_most_used(Terminal &terminal, const Results &results);
} // namespace Voussoir

#endif
