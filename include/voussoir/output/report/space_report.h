// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_space_report_h
#define voussoir_output_report_space_report_h

#include <voussoir/output/report/space/report_content.h>

#include <iosfwd>

namespace Voussoir
{
/**
 * Write a packing in space as a page of HTML that needs no other file: a view
 * by WebGL that the reader turns, cuts and takes apart, with the numbers of
 * each block and joint, and an isometric picture where there is no WebGL or no
 * script, and for print. The picture is left out if it has more than
 * most_faces_in_picture faces.
 *
 * @throws InputError if the content cannot be shown, see check_content().
 */
void write_space_report(std::ostream &out, const SpaceReport &report);
} // namespace Voussoir

#endif
