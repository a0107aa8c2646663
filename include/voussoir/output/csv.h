// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_csv_h
#define voussoir_output_csv_h

#include <voussoir/output/results.h>

#include <iosfwd>
#include <string>

namespace Voussoir
{
// The tables. Numbers are read back as the same doubles; see TextLines.

/** @{ */
/** The name of a file, written by the function that is named like it. */
inline const std::string interfaces_csv = "interfaces.csv";
inline const std::string cells_csv = "cells.csv";
inline const std::string boundary_csv = "boundary.csv";
inline const std::string mechanism_csv = "mechanism.csv";
inline const std::string mechanism_joints_csv = "mechanism_joints.csv";
/** @} */

/**
 * One line per interface, in the order of Packing::interfaces().
 *
 * It has the cells, with -1 for the ground, the ends, the normal from c- to c+,
 * the length, f_e^n and f_e^t (forces per unit thickness on c-, f_e^n negative
 * in compression), s_e (a stress) and |f_e^t| / (s_e |e|); and, if the
 * formulation finds out, 1 where every admissible and balanced state has
 * f_e^n = 0, and |f_e^t| = s_e |e|. Where blocks turn also what of f_e^n acts
 * at the start and at the end, and InterfaceForces::eccentricity(). The branch
 * vector, at the end, runs from x_c- to x_c+, or to the midpoint of a support.
 */
void write_interfaces_csv(std::ostream &out, const Results &results);

/**
 * One line per boundary edge: its cell, ends, normal and length; the force of
 * the traction on it and its EdgeTractions::first_moment; and the branch vector
 * from x_c to its midpoint. With the forces and branch vectors of the
 * interfaces these add up to the mean stress of the packing.
 */
void write_boundary_csv(std::ostream &out, const Results &results);

/**
 * One line per cell: its number, centre and area, the load F_c (a force per
 * unit thickness), the displacement, the residual torque about the centre (a
 * force), the mean stress and the name of its group; where blocks turn also the
 * torque of the load and the angle, see Motion.
 */
void write_cells_csv(std::ostream &out, const Results &results);

/**
 * One line per cell: its number, centre, load F_c, displacement along @p
 * motion, and the name of its group; where blocks turn also the torque of the
 * load and the angle.
 */
void write_mechanism_csv(std::ostream &out,
                         const Scene &scene,
                         const Motion &motion);

/**
 * One line per interface: the cells (-1: the ground), the normal, the length,
 * s_e, and along @p motion the opening and the sliding. These are the normal
 * and the tangential component of the jump [u]_e at the midpoint; where blocks
 * turn also the openings at the start and at the end.
 */
void write_mechanism_joints_csv(std::ostream &out,
                                const Scene &scene,
                                const Motion &motion);
} // namespace Voussoir

#endif
