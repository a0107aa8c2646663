// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_vtu_tetrahedra_vtu_h
#define voussoir_output_vtu_tetrahedra_vtu_h

#include <voussoir/output/space_results.h>

#include <iosfwd>

namespace Voussoir
{
/**
 * The stress in space as a VTK unstructured grid of tetrahedra, stress.vtu.
 * Cell data are the tensor stress (nine components, row by row),
 * principal_stress_1 >= principal_stress_3 of its symmetric part, skew, the
 * size of the axial vector of the other, div, cell, group (its number in
 * summary.json), and reconstructed, which is 0 where the cell's mean stress had
 * to stand in; point data is the displacement.
 */
void write_tetrahedra_vtu(std::ostream &out, const SpaceResults &results);
} // namespace Voussoir

#endif
