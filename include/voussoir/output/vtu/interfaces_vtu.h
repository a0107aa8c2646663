// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_vtu_interfaces_vtu_h
#define voussoir_output_vtu_interfaces_vtu_h

#include <voussoir/output/results.h>

#include <iosfwd>
#include <string>

namespace Voussoir
{
/** The name of the file. */
inline const std::string interfaces_vtu = "interfaces.vtu";

/**
 * The interfaces as a VTK unstructured grid of lines, with interface_fields()
 * as cell data.
 */
void write_interfaces_vtu(std::ostream &out, const Results &results);

/** The name of the file that the next function writes. */
inline const std::string mechanism_joints_vtu = "mechanism_joints.vtu";

/**
 * The jumps of a motion at the interfaces, where these are at rest, one line
 * for each, with mechanism_joint_fields() as cell data, of the size of the
 * motion.
 */
void write_mechanism_joints_vtu(std::ostream &out,
                                const Scene &scene,
                                const Motion &motion);

/** @{ */
/** The names of the files that the next functions write. */
inline const std::string links_vtu = "links.vtu";
inline const std::string mechanism_links_vtu = "mechanism_links.vtu";
/** @} */

/** One line for each link, from place to place, with link_fields(). */
void write_links_vtu(std::ostream &out, const Results &results);

/** These lines with mechanism_link_fields() of a motion. */
void write_mechanism_links_vtu(std::ostream &out,
                               const Scene &scene,
                               const Motion &motion);
} // namespace Voussoir

#endif
