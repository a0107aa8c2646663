// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_vtu_h
#define voussoir_output_vtu_h

#include <voussoir/output/results.h>

#include <iosfwd>

namespace Voussoir
{
/**
 * The stress as a VTK unstructured grid of the sub-cells, with values that are
 * constant in each: the tensor stress, principal_stress_1 >=
 * principal_stress_2, von_mises (of plane stress), skew = (sigma_xy -
 * sigma_yx)/2, div, cell, group (its number in summary.json), displacement, and
 * reconstructed, which is 0 where the
 * cell's mean stress had to stand in.
 */
void write_stress_vtu(std::ostream &out, const Results &results);

/**
 * The interfaces as lines, with the normal and tangential force and stress, the
 * strength, the utilisation and the numbers of the cells, -1 for the ground;
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
