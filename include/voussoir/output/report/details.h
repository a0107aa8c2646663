// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_details_h
#define voussoir_output_report_details_h

#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/** How the user names the units of his numbers; empty if he does not. */
struct UnitNames
{
  std::string length; /**< of L */
  std::string stress; /**< of S */
  std::string force;  /**< of S L, force per unit thickness */

  /** "name (unit)", or the name alone. */
  static std::string labelled(const std::string &name, const std::string &unit)
  {
    return unit.empty() ? name : name + " (" + unit + ')';
  }
};

/** What a report says beside the results. */
struct ReportDetails
{
  /** The units of legends. */
  UnitNames units;
  /** Names, as in "Loads/Body force", and values of what the user has set. */
  std::vector<std::pair<std::string, std::string>> parameters;
  /** Warnings of the run. */
  std::vector<std::string> warnings;
};

} // namespace Voussoir

#endif
