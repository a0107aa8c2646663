// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_checked_packing_h
#define voussoir_run_checked_packing_h

#include <voussoir/packing/polyhedra/packing.h>

#include <vector>

namespace Voussoir
{
/** A packing in space with its supports, and what is wrong with its blocks. */
struct CheckedPacking
{
  /** The packing. */
  Packing<3> packing;
  /** What a file had that was mended, or is tolerated. */
  std::vector<CellDefect> defects;
};
} // namespace Voussoir

#endif
