// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_command_line_bash_completion_h
#define voussoir_run_command_line_bash_completion_h

#include <nlohmann/json.hpp>

#include <iosfwd>
#include <string>
#include <vector>

namespace Voussoir
{
/**
 * Print a script that lets bash complete the arguments of the program: options,
 * files, and the entries and values behind --set, --sweep and --find.
 *
 * @param options such as "--set".
 * @param parameters as tree_of() gives them.
 */
void print_bash_completion(std::ostream &out,
                           const std::vector<std::string> &options,
                           const nlohmann::ordered_json &parameters);
} // namespace Voussoir

#endif
