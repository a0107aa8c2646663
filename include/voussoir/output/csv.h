// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_csv_h
#define voussoir_output_csv_h

#include <voussoir/output/results.h>

#include <iosfwd>
#include <string>

namespace Voussoir
{
// The tables, whose columns are those of output/fields/tables.h, where results
// have them. Numbers are read back as the same doubles; see TextLines.

/** @{ */
/** The name of a file, written by the function that is named like it. */
inline const std::string interfaces_csv = "interfaces.csv";
inline const std::string cells_csv = "cells.csv";
inline const std::string boundary_csv = "boundary.csv";
inline const std::string links_csv = "links.csv";
inline const std::string capacity_csv = "capacity.csv";
inline const std::string mechanism_csv = "mechanism.csv";
inline const std::string mechanism_joints_csv = "mechanism_joints.csv";
inline const std::string mechanism_links_csv = "mechanism_links.csv";
/** @} */

/** One line per interface, in their order, with interface_fields(). */
void write_interfaces_csv(std::ostream &out, const Results &results);

/**
 * One line per boundary edge, with boundary_fields(). With the forces and
 * branch vectors of the interfaces these add up to the mean stress of the
 * packing.
 */
void write_boundary_csv(std::ostream &out, const Results &results);

/** One line per cell, with cell_fields(). */
void write_cells_csv(std::ostream &out, const Results &results);

/**
 * One line per cell, with mechanism_fields() of @p motion.
 *
 * @param live loads of which it bounds the factor, or null.
 */
void write_mechanism_csv(std::ostream &out,
                         const Scene &scene,
                         const Motion &motion,
                         const LiveLoads *live = nullptr);

/** One line per interface, with mechanism_joint_fields() of @p motion. */
void write_mechanism_joints_csv(std::ostream &out,
                                const Scene &scene,
                                const Motion &motion);

/** One line per position of the CapacityCurve, with capacity_fields(). */
void write_capacity_csv(std::ostream &out, const Results &results);

/** One line per link, with link_fields(). */
void write_links_csv(std::ostream &out, const Results &results);

/** One line per link, with mechanism_link_fields() of @p motion. */
void write_mechanism_links_csv(std::ostream &out,
                               const Scene &scene,
                               const Motion &motion);
} // namespace Voussoir

#endif
