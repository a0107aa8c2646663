// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_vtu_polyhedra_vtu_h
#define voussoir_output_vtu_polyhedra_vtu_h

#include <voussoir/output/space_results.h>

#include <iosfwd>

namespace Voussoir
{
/**
 * The polyhedra of a packing, fixed ones included, as a VTK unstructured grid
 * of polyhedra that share no points, with polyhedron_fields() as cell data, and
 * where they move the displacement of each point.
 */
void write_blocks_vtu(std::ostream &out, const SpaceResults &answer);

/**
 * The interfaces as a VTK unstructured grid of polygons, with
 * face_interface_fields() as cell data.
 */
void write_interfaces_vtu(std::ostream &out, const SpaceResults &answer);
} // namespace Voussoir

#endif
