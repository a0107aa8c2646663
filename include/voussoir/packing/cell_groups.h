// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_cell_groups_h
#define voussoir_packing_cell_groups_h

#include <voussoir/packing/packing.h>
#include <voussoir/packing/polyhedra/packing.h>

#include <string>
#include <vector>

namespace Voussoir
{
/**
 * The number of the group @p name.
 *
 * @throws InputError naming @p parameter and listing the groups if there is
 *   none of that name.
 */
template <int dim>
unsigned int group_of_name(const Packing<dim> &packing,
                           const std::string &name,
                           const std::string &parameter);

/**
 * The numbers of the cells that a user calls @p name, ascending: those of a
 * group, or the one of "cell" and a number. The ground is Packing::ground().
 *
 * @throws InputError as group_of_name() does, or if there is no such cell.
 */
template <int dim>
std::vector<unsigned int> cells_of_name(const Packing<dim> &packing,
                                        const std::string &name,
                                        const std::string &parameter);

/**
 * Put cells into groups by the list @p groups, "name: condition; ...", where
 * the conditions are expressions in the coordinates x, y, z of the centre. Of
 * the conditions that a cell meets the last one counts; one that meets none
 * keeps the group it has.
 *
 * @throws InputError if a condition cannot be evaluated or is met by no cell.
 */
template <int dim>
void assign_groups(Packing<dim> &packing, const std::string &groups);
} // namespace Voussoir

#endif
