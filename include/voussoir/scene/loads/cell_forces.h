// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_loads_cell_forces_h
#define voussoir_scene_loads_cell_forces_h

#include <voussoir/packing/packing.h>

#include <deal.II/base/tensor.h>

#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** A force on each of some cells. */
struct CellForce
{
  /** The name that the user gave the cells. */
  std::string name;
  /** Their numbers, ascending. */
  std::vector<unsigned int> cells;
  /** On each cell; per unit thickness. */
  dealii::Tensor<1, 2> force;
  /**
   * Where it acts, in the only cell; a length. None: evenly over the area of
   * each cell, so at its centroid.
   */
  std::optional<dealii::Point<2>> place = {};

  /**
   * How the force acts on @p cell.
   *
   * @return the place, or the centroid; a length.
   */
  dealii::Point<2> place_in(const Packing<2> &packing, unsigned int cell) const;
  /** The torque of that about x_c, positive counterclockwise; S L^2. */
  double torque(const Packing<2> &packing, unsigned int cell) const;
};

/**
 * The forces that a user gives as a list of
 *
 * - "name: F_x, F_y" on each cell of that name,
 * - "name: F_x, F_y at x, y" on one cell, at a place in it, or
 * - "at x, y: F_x, F_y" on the cell at that place; where several touch there
 *   each takes the same share.
 *
 * or as lists "list F_x, ...; list F_y, ..." with a number for each cell, at
 * its centroid.
 *
 * @param parameter its name, for messages.
 * @throws InputError as vectors_of_lists() does; if an element has none of
 * these forms, a name is that of no cell, or a place is in no cell or not in
 * that one.
 */
std::vector<CellForce> cell_forces_of_text(const Packing<2> &packing,
                                           const std::string &list,
                                           const std::string &parameter);
} // namespace Voussoir

#endif
