// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_loads_loaded_cells_h
#define voussoir_scene_loads_loaded_cells_h

#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/cell_groups.h>

#include <string>
#include <vector>

namespace Voussoir
{
/**
 * The cells of a @p name, which take a force.
 *
 * @param what they are given, for messages.
 * @throws InputError as cells_of_name() does, or if there are none, or some
 * that do not move, as the ground.
 */
template <int dim>
std::vector<unsigned int> cells_that_take(const std::string &what,
                                          const Packing<dim> &packing,
                                          const std::string &name,
                                          const std::string &parameter)
{
  std::vector<unsigned int> cells = cells_of_name(packing, name, parameter);
  // Those that do not move are behind all others.
  if (cells.empty() || cells.back() >= packing.ground())
    throw InputError("The parameter '" + parameter + "' gives " + what +
                     " to '" + name +
                     "', which has no cells to take it; name another group, or "
                     "a cell by its number.");
  return cells;
}

/**
 * The cells of a @p name, which are given a body force for the first time.
 *
 * @param has_own true of those that have been given one; these are added.
 * @throws InputError as cells_that_take(), or if one has its own.
 */
template <int dim>
std::vector<unsigned int> new_cells(const Packing<dim> &packing,
                                    const std::string &name,
                                    const std::string &parameter,
                                    std::vector<bool> &has_own)
{
  std::vector<unsigned int> cells =
      cells_that_take("a body force", packing, name, parameter);
  for (const unsigned int c : cells)
  {
    if (has_own[c])
      throw InputError(
          text("The parameter '", parameter, "' gives a body force to cell ", c,
               " twice, the second time as '", name, "'; give it once."));
    has_own[c] = true;
  }
  return cells;
}
} // namespace Voussoir

#endif
