// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_group_names_h
#define voussoir_packing_group_names_h

#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/** The name of the group of what supports the packing. */
extern const std::string ground_name;

/**
 * The fault of @p name as the name of a group of cells, as the end of a
 * sentence about it; empty if nothing is. Names stand in lists of parameters
 * and in files, so they have none of the characters that separate there.
 */
std::string fault_of_group_name(const std::string &name);

/** True if @p name stands for a cell by its number, as "cell 12" or "cell12".
 */
bool is_name_of_cell(const std::string &name);

/** The name in quotes for a message, with ? for what cannot be shown. */
std::string quoted_group_name(const std::string &name);

/** @throws InputError if @p name cannot be that of a group of cells. */
void check_group_name(const std::string &name);

/**
 * Split a list "name: value | name: value", as parameters about groups of cells
 * have it, into names and values without the spaces around them. The bars may
 * be semicolons.
 *
 * @param of_vectors true if semicolons also separate the components of a value:
 *   where there is no bar, one without a name behind it does.
 * @throws InputError naming @p parameter if an element has no name or value.
 */
std::vector<std::pair<std::string, std::string>>
split_named_list(const std::string &list,
                 const std::string &parameter,
                 bool of_vectors = false);

/** The names between commas, one at least; empty where nothing stands. */
std::vector<std::string> split_names(const std::string &names);

/** The parts of @p list between bars; not between "||", the "or" of formulas.*/
std::vector<std::string> split_at_bars(const std::string &list);
} // namespace Voussoir

#endif
