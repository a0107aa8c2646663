// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_cell_range_h
#define voussoir_packing_cell_range_h

#include <voussoir/packing/packing.h>

namespace Voussoir
{
/** The cells from @p begin to @p end - 1. */
struct CellRange
{
  unsigned int begin; /**< the number of the first */
  unsigned int end;   /**< one behind that of the last */
};

/** The range of all cells. */
inline CellRange all_cells(const Packing<2> &packing)
{
  return {0, packing.n_cells()};
}

/**
 * Some cells of a packing, each with vertices of its own, so that they touch
 * nothing: a Packing made of them has boundary edges only, one a side, in the
 * order of Packing::first_side(). Centres and groups are kept.
 */
CellLoops cut_free(const Packing<2> &packing, const CellRange &cells);
} // namespace Voussoir

#endif
