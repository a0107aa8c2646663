// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_report_h
#define voussoir_output_report_report_h

#include <voussoir/output/report/details.h>
#include <voussoir/output/report/page_data.h>
#include <voussoir/output/results.h>
#include <voussoir/packing/polygons/drawing_faults.h>

#include <iosfwd>
#include <string>

namespace Voussoir
{
/** The name of the page. */
inline const std::string report_html = "report.html";
/** The name of that of a drawing that is refused. */
inline const std::string drawing_check_html = "drawing_check.html";

/** @{ */
/**
 * Write what was found as a page of HTML that needs no other file: the verdict,
 * a picture with several views, the tables of the .csv files behind it, and the
 * most important numbers. With more than most_cells_in_full cells it has
 * neither these tables nor the forces and stresses of each joint and cell.
 */
void write_report(std::ostream &out,
                  const Results &results,
                  const ReportDetails &details);
void write_report(std::ostream &out,
                  const Collapse &collapse,
                  const ReportDetails &details);
/** @} */

/** Write a page of a drawing that is refused: a picture with its faults. */
void write_report(std::ostream &out, const DrawingRefused &refused);
} // namespace Voussoir

#endif
