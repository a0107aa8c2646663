// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_parameter_tree_h
#define voussoir_base_parameter_tree_h

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <sstream>

namespace Voussoir
{
/** All sections and entries in their order, as deal.II writes them as JSON. */
inline nlohmann::ordered_json tree_of(const dealii::ParameterHandler &prm)
{
  std::stringstream text;
  prm.print_parameters(text,
                       dealii::ParameterHandler::JSON |
                           dealii::ParameterHandler::KeepDeclarationOrder);
  return nlohmann::ordered_json::parse(text);
}

/** True if a node of it is an entry, and not a section. */
inline bool is_entry(const nlohmann::ordered_json &node)
{
  return node.contains("pattern_description");
}
} // namespace Voussoir

#endif
