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
 * The interfaces as a VTK unstructured grid of lines. Cell data are force, the
 * vector f_e^n n_e + f_e^t t_e on c-, normal_force and tangential_force, its
 * components (S L), normal_stress and tangential_stress, the same over |e| (S),
 * strength (S), utilisation, and cell_minus and cell_plus, the numbers of the
 * cells, -1 for the ground; and never_pressed and always_sliding, if the
 * formulation finds out (see Results).
 */
void write_interfaces_vtu(std::ostream &out, const Results &results);

/** The name of the file that the next function writes. */
inline const std::string mechanism_joints_vtu = "mechanism_joints.vtu";

/**
 * The jumps of a motion at the interfaces, where these are at rest, one line
 * for each, with the fields of mechanism_joints.csv: opening and sliding, of
 * the size of the motion, dissipation, and where blocks turn opening_0 and
 * opening_1.
 */
void write_mechanism_joints_vtu(std::ostream &out,
                                const Scene &scene,
                                const Motion &motion);
} // namespace Voussoir

#endif
