// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_cell_defects_h
#define voussoir_packing_polyhedra_cell_defects_h

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <string>

namespace Voussoir
{
/** What was wrong with a cell of a file, and was mended or is tolerated. */
struct CellDefect
{
  /** The number of the kind, for files; see ModelDefect::Kind. */
  unsigned int kind = 0;
  /** What it is, such as "faces listed twice". */
  std::string what;
  /** What was done, or is to be done, such as "taken once". */
  std::string action;
  /** The cell that has it; invalid if none does. */
  unsigned int cell = dealii::numbers::invalid_unsigned_int;
  /** The number of faces, vertices or parts that have it. */
  unsigned int count = 1;
  /** The first or the worst face, as the file numbers it in its block from
   * zero; invalid if it is not of a face. */
  unsigned int face = dealii::numbers::invalid_unsigned_int;
  /** How large the worst one is, a length; zero if it has no size. */
  double size = 0.;
  /** Where the first or the worst one is; a length. */
  dealii::Point<3> place = {};
  /** A name, or another cell; empty if there is none. */
  std::string detail = {};

  /** True if it is in some cell, and has a place. */
  bool has_place() const
  {
    return cell != dealii::numbers::invalid_unsigned_int;
  }
};
} // namespace Voussoir

#endif
