// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_vtu_packing_files_h
#define voussoir_output_vtu_packing_files_h

#include <voussoir/packing/packing.h>

#include <iosfwd>
#include <string>

namespace Voussoir
{
/** @{ */
/** The name of a file, written by the function that is named like it. */
inline const std::string packing_wkt = "packing.wkt";
inline const std::string packing_off = "packing.off";
inline const std::string packing_obj = "packing.obj";
inline const std::string packing_json = "packing.json";
inline const std::string packing_centres = "packing_centres.txt";
/** @} */

/**
 * @name Files of a packing
 * From them the generator "polygons" makes the same packing again: the same
 * cells, interfaces and boundary edges in the same order, with the same
 * coordinates to the last bit.
 * @{
 */

/**
 * One POLYGON a line, as read_wkt_file() reads it, with the name of the cell's
 * group behind a semicolon.
 */
void write_packing_wkt(std::ostream &out, const Packing<2> &packing);

/** The cells as faces of an OFF file, without their groups; z is zero. */
void write_packing_off(std::ostream &out, const Packing<2> &packing);

/** The centre "x y" of one cell a line, as read_points_file() reads it. */
void write_centres(std::ostream &out, const Packing<2> &packing);
/** @} */
} // namespace Voussoir

#endif
