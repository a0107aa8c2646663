// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_vtu_blocks_vtu_h
#define voussoir_output_vtu_blocks_vtu_h

#include <voussoir/output/results.h>

#include <iosfwd>
#include <string>

namespace Voussoir
{
/** @{ */
/** The name of a file, written by the function that is named like it. */
inline const std::string blocks_vtu = "blocks.vtu";
inline const std::string mechanism_vtu = "mechanism.vtu";
/** @} */

/**
 * The blocks as a VTK unstructured grid of polygons, one for each cell, that
 * share no points. Cell data are cell_fields(), and point data is the
 * displacement (L).
 */
void write_blocks_vtu(std::ostream &out, const Results &results);

/**
 * The blocks where they are, as polygons, with @p motion times @p factor as
 * displacement (point data): warped by it they show the mechanism. Cell data
 * are mechanism_fields().
 */
void write_mechanism_vtu(std::ostream &out,
                         const Scene &scene,
                         const Motion &motion,
                         double factor);
} // namespace Voussoir

#endif
