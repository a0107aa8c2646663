// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_unused_settings_h
#define voussoir_run_unused_settings_h

#include <voussoir/base/parameters/assigned_entries.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/**
 * Sentences for the user on entries that were assigned a value, be it the
 * default, and that the run does not look at, since they belong to another
 * generator, formulation or accuracy: one sentence for each section.
 */
std::vector<std::string> unused_settings(const AssignedEntries &assigned);

/** Names, as in "Friction/Strength", and their values. */
using NamesAndValues = std::vector<std::pair<std::string, std::string>>;

/** The entries that have another value than their default. */
NamesAndValues changed_settings(const dealii::ParameterHandler &prm);
} // namespace Voussoir

#endif
