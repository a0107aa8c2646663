// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_verdict_h
#define voussoir_output_report_verdict_h

#include <voussoir/output/report/details.h>
#include <voussoir/output/results.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** What a page says before all else, without HTML. */
struct ReportVerdict
{
  /** A class of the style sheet: "carried", "within" or "collapse". */
  std::string kind;
  /** One sentence, with four digits. */
  std::string sentence;
  /** A sentence for each analysis beside it. */
  std::vector<std::string> beside;
  /** The paragraphs on why that is so, with all digits. */
  std::vector<std::string> proof;
};

/** The verdict on a run. @param names the units of its numbers. */
ReportVerdict verdict_of(const Results &results, const UnitNames &names);
/** The verdict on loads that are not carried. */
ReportVerdict verdict_of(const Collapse &collapse);
} // namespace Voussoir

#endif
