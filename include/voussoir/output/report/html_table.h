// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_html_table_h
#define voussoir_output_report_html_table_h

#include <voussoir/output/report/colour_scale.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** A table under a heading. */
class HtmlTable
{
public:
  /** @param columns their titles; none for a table of names and values. */
  HtmlTable(const std::string &id,
            const std::string &heading,
            const std::vector<std::string> &columns = {})
      : html("<section id=\"" + id + "\">\n<h2>" + html_text(heading) +
             "</h2>\n<div class=\"wide\"><table>\n")
  {
    if (columns.empty())
      return;
    html += "<tr>";
    for (const std::string &column : columns)
      html += "<th>" + html_text(column) + "</th>";
    html += "</tr>\n";
  }

  /** Add a row of HTML. */
  HtmlTable &row(const std::vector<std::string> &cells)
  {
    html += "<tr>";
    for (const std::string &cell : cells)
      html += "<td>" + cell + "</td>";
    html += "</tr>\n";
    return *this;
  }

  /** All of it. */
  std::string close() const { return html + "</table></div>\n</section>\n"; }

private:
  std::string html;
};
} // namespace Voussoir

#endif
