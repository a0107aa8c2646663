// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_cells_at_h
#define voussoir_packing_cells_at_h

#include <voussoir/packing/packing.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** The cells of a packing at a place. */
struct CellsAt
{
  /** Look for those at @p x; coordinates are often written with few digits. */
  CellsAt(const Packing<2> &packing, const dealii::Point<2> &x);

  /** Those that it is in or on the sides of; ascending numbers. */
  std::vector<unsigned int> there;
  /** The nearest of all. */
  unsigned int nearest = 0;
  /** How far that is away; a length. */
  double distance;

  /** The end of a sentence on a place that is in no cell. */
  std::string describe_nearest(const Packing<2> &packing) const;
};

/** True if @p x is in @p cell or on its sides. */
bool is_in_cell(const Packing<2> &packing,
                unsigned int cell,
                const dealii::Point<2> &x);
} // namespace Voussoir

#endif
