// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_vtu_stress_vtu_h
#define voussoir_output_vtu_stress_vtu_h

#include <voussoir/packing/packing.h>
#include <voussoir/scene/motion.h>
#include <voussoir/stress/reconstruction.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace Voussoir
{
/** @{ */
/** The name of a file, written by the function that is named like it. */
inline const std::string stress_vtu = "stress.vtu";
inline const std::string stress_pvtu = "stress.pvtu";
/** @} */

/** The content of stress.vtu: some cells and the stress inside them. */
struct StressedCells
{
  /** The cells. */
  const Packing<2> &packing;
  /** The stress in their sub-cells. */
  const StressField &stress;
  /** The motion of the cells; L. */
  const Motion &motion;
  /** The number of the first cell, if others are elsewhere. */
  unsigned int first_cell = 0;
  /** The number of each, if they are pieces; else null. */
  const std::vector<unsigned int> *numbers = nullptr;
};

/**
 * The stress as a VTK unstructured grid of the sub-cells. Cell data are the
 * tensor stress (nine components, row by row), principal_stress_1 >=
 * principal_stress_2, von_mises (of plane stress), skew, the root of the mean
 * square of (sigma_yx - sigma_xy)/2, div, cell, group (its number in
 * summary.json), and reconstructed, which is 0 where the cell's mean stress had
 * to stand in; point data is the displacement. All in double precision, but for
 * numbers and marks, which are integers.
 */
void write_stress_vtu(std::ostream &out, const StressedCells &cells);

/**
 * The .pvtu that makes one grid of @p pieces, .vtu files with the same fields,
 * by their names beside it.
 */
void write_stress_pvtu(std::ostream &out,
                       const StressedCells &cells,
                       const std::vector<std::string> &pieces);
} // namespace Voussoir

#endif
