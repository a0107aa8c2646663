// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_sections_h
#define voussoir_output_report_sections_h

#include <voussoir/output/report/details.h>
#include <voussoir/output/results.h>

#include <string>

namespace Voussoir
{
/** @{ */
/** What stands below the picture, as HTML. */
std::string sections_of(const Results &results, const ReportDetails &details);
std::string sections_of(const Collapse &collapse, const ReportDetails &details);
/** @} */
} // namespace Voussoir

#endif
