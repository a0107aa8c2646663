// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_vtu_h
#define voussoir_output_vtu_h

#include <voussoir/output/results.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace Voussoir
{
/** What stress.vtu shows: some cells and the stress inside them. */
struct StressedCells
{
  const Packing &packing;
  const StressField &stress;
  /** Of each cell. */
  const std::vector<dealii::Tensor<1, 2>> &displacement;
  /** The number of the first cell, if others are elsewhere. */
  unsigned int first_cell = 0;
};

/**
 * The stress as a VTK unstructured grid of the sub-cells, with cell data: the
 * tensor stress (nine components, row by row), principal_stress_1 >=
 * principal_stress_2, von_mises (of plane stress), skew = (sigma_xy -
 * sigma_yx)/2, div, cell, group (its number in summary.json), displacement, and
 * reconstructed, which is 0 where the cell's mean stress had to stand in. All
 * in double precision, but for numbers and marks, which are integers.
 */
void write_stress_vtu(std::ostream &out, const StressedCells &cells);

/**
 * The .pvtu that makes one grid of @p pieces, .vtu files with the same fields,
 * by their names beside it.
 */
void write_stress_pvtu(std::ostream &out,
                       const StressedCells &cells,
                       const std::vector<std::string> &pieces);

/**
 * The interfaces as lines, with the normal and tangential force and stress, the
 * strength, the utilisation and the numbers of the cells, -1 for the ground, as
 * cell data;
 * and never_pressed and always_sliding, if the formulation finds out (see
 * Results).
 */
void write_interfaces_vtu(std::ostream &out, const Results &results);

/**
 * The blocks moved along the mechanism, the largest component of the movement
 * being the mean size of a cell (the root of its mean area), with the
 * displacement and the cell. Warped by minus the displacement they are where
 * they were.
 */
void write_mechanism_vtu(std::ostream &out, const Collapse &collapse);
} // namespace Voussoir

#endif
