// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_unused_settings_h
#define voussoir_unused_settings_h

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/**
 * Sentences for the user on entries that were given a value and that the run
 * does not look at, since they belong to another generator, formulation or
 * accuracy: one sentence for each section.
 */
std::vector<std::string> unused_settings(const dealii::ParameterHandler &prm);

/** The same of all sections and entries, as tree_of() gives them. */
std::vector<std::string> unused_settings(const nlohmann::ordered_json &tree);

/** Names, as in "Friction/Strength", and their values. */
using NamesAndValues = std::vector<std::pair<std::string, std::string>>;

/** The entries that have another value than their default. */
NamesAndValues changed_settings(const dealii::ParameterHandler &prm);
} // namespace Voussoir

#endif
