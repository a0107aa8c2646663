// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/csv.h>
#include <voussoir/output/report/colour_scale.h>
#include <voussoir/output/report/page_parts.h>
#include <voussoir/output/report/report.h>
#include <voussoir/output/report/sections.h>
#include <voussoir/output/report/views.h>
#include <voussoir/report_page.h>
#include <voussoir/version.h>

#include <algorithm>
#include <ostream>
#include <sstream>

namespace Voussoir
{
namespace
{
/** The buttons that switch between views. */
std::string switch_of(const Picture &picture)
{
  std::string html;
  for (const View &view : picture.views)
    html += "<input type=\"radio\" name=\"view\" id=\"view-" + view.id + '"' +
            (html.empty() ? " checked" : "") + "><label for=\"view-" + view.id +
            "\">" + view.name + "</label>";
  return html;
}

std::string legends_of(const Picture &picture)
{
  std::string html;
  for (const View &view : picture.views)
    html +=
        "<div class=\"legend in-" + view.id + "\">" + view.legend + "</div>\n";
  return html;
}

/** A table of csv.h, as the text of an element that holds no HTML. */
template <typename Writer>
std::string table(const Writer &writer)
{
  std::ostringstream out;
  writer(out);
  std::string csv = out.str();
  // Nothing in it may end the element.
  std::replace(csv.begin(), csv.end(), '<', '(');
  return csv;
}

void write_page(std::ostream &out,
                const std::string &title,
                const Picture &picture,
                const ReportDetails &details,
                PageParts parts)
{
  parts["title"] = html_text(title.empty() ? "Voussoir" : title);
  parts["version"] = VOUSSOIR_VERSION;
  parts["css"] = page_css;
  parts["js"] = page_js;
  parts["style"] = picture.style;
  parts["switch"] = switch_of(picture);
  parts["legends"] = legends_of(picture);
  parts["view_box"] = picture.drawing.view_box();
  parts["elements"] = picture.drawing.elements();
  for (const std::string &warning : details.warnings)
    parts["warnings"] +=
        "<p class=\"warning\">" + html_text(warning) + "</p>\n";
  parts["warnings"] += ""; // it is there without any
  fill_page(out, page_html, parts);
}

bool in_full(const RunRecord &run)
{
  return run.scene.packing.n_cells() <= most_cells_in_full;
}

/** The tables behind the picture, and what the reader is told of them. */
template <typename Blocks, typename Joints>
PageParts tables(const bool in_full, const Blocks &blocks, const Joints &joints)
{
  if (!in_full)
    return {{"blocks", ""},
            {"joints", ""},
            {"hint", "There are too many blocks for their numbers."}};
  return {{"blocks", table(blocks)},
          {"joints", table(joints)},
          {"hint", "Point at a block or a joint for its numbers, which are "
                   "those of the .csv files; click to keep them."}};
}
} // namespace

void write_report(std::ostream &out,
                  const Results &results,
                  const ReportDetails &details)
{
  PageParts parts = tables(
      in_full(results),
      [&](std::ostream &csv) { write_cells_csv(csv, results); },
      [&](std::ostream &csv) { write_interfaces_csv(csv, results); });
  parts["kind"] =
      results.status.kind == Status::Kind::solved ? "carried" : "within";
  parts["verdict"] = html_text(verdict_of(results));
  parts["sections"] = sections_of(results, details);
  write_page(out, results.title,
             picture_of(results, details.units, in_full(results)), details,
             std::move(parts));
}

void write_report(std::ostream &out,
                  const Collapse &collapse,
                  const ReportDetails &details)
{
  const Scene &scene = collapse.scene;
  PageParts parts = tables(
      in_full(collapse),
      [&](std::ostream &csv) {
        write_mechanism_csv(csv, scene, collapse.motion);
      },
      [&](std::ostream &csv) {
        write_mechanism_joints_csv(csv, scene, collapse.motion);
      });
  parts["kind"] = "collapse";
  parts["verdict"] = html_text(verdict_of(collapse));
  parts["sections"] = sections_of(collapse, details);
  write_page(out, collapse.title,
             picture_of(collapse, details.units, in_full(collapse)), details,
             std::move(parts));
}

void write_report(std::ostream &out, const DrawingRefused &refused)
{
  const std::string message = refused.what();
  const std::size_t first_line = message.find('\n');
  PageParts parts = {{"blocks", ""}, {"joints", ""}, {"hint", ""}};
  parts["kind"] = "collapse";
  parts["verdict"] = html_text(message.substr(0, first_line));
  if (first_line != message.npos)
    parts["sections"] = "<section><h2>Faults</h2>\n<pre class=\"faults\">" +
                        html_text(message.substr(first_line + 1)) +
                        "</pre></section>";
  else
    parts["sections"] = "";
  write_page(out, "Check of a drawing", picture_of(refused.check), {},
             std::move(parts));
}
} // namespace Voussoir
