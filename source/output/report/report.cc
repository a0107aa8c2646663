// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/report/colour_scale.h>
#include <voussoir/output/report/page_data.h>
#include <voussoir/output/report/report.h>
#include <voussoir/output/report/sections.h>
#include <voussoir/output/report/verdict.h>
#include <voussoir/output/report/views.h>
#include <voussoir/report_page.h>
#include <voussoir/version.h>

#include <ostream>
#include <utility>

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

std::string paragraphs(const std::vector<std::string> &sentences,
                       const std::string &kind)
{
  const std::string begin = kind.empty() ? "<p>" : "<p class=\"" + kind + "\">";
  std::string html;
  for (const std::string &sentence : sentences)
    html += begin + html_text(sentence) + "</p>\n";
  return html;
}

/** The scripts of the page, in the order in which they need each other. */
std::string scripts()
{
  std::string all;
  for (const char *const script :
       {page_zoom_js, page_numbers_js, page_motion_js, page_save_js, page_js})
    all += script;
  return all;
}

void write_page(std::ostream &out,
                const std::string &title,
                const Picture &picture,
                const ReportVerdict &verdict,
                const std::vector<std::string> &warnings,
                PageParts parts)
{
  parts["title"] = html_text(title.empty() ? "Voussoir" : title);
  parts["version"] = VOUSSOIR_VERSION;
  parts["css"] = page_css;
  parts["js"] = scripts();
  parts["style"] = picture.style;
  parts["switch"] = switch_of(picture);
  parts["legends"] = legends_of(picture);
  parts["view_box"] = picture.drawing.view_box();
  parts["elements"] = picture.drawing.elements();
  parts["kind"] = verdict.kind;
  parts["verdict"] = html_text(verdict.sentence);
  parts["beside"] = paragraphs(verdict.beside, "answer");
  parts["proof"] = verdict.proof.empty()
                       ? ""
                       : "<details id=\"certificate\"><summary>How this is "
                         "proven</summary>\n" +
                             paragraphs(verdict.proof, "") + "</details>\n";
  parts["warnings"] = paragraphs(warnings, "warning");
  fill_page(out, page_html, parts);
}
} // namespace

void write_report(std::ostream &out,
                  const Results &results,
                  const ReportDetails &details)
{
  const Picture picture =
      picture_of(results, details.units, is_in_full(results));
  PageParts parts = page_data_of(results, picture, details.units);
  parts["sections"] = sections_of(results, details);
  write_page(out, results.title, picture, verdict_of(results, details.units),
             details.warnings, std::move(parts));
}

void write_report(std::ostream &out,
                  const Collapse &collapse,
                  const ReportDetails &details)
{
  const Picture picture =
      picture_of(collapse, details.units, is_in_full(collapse));
  PageParts parts = page_data_of(collapse, picture, details.units);
  parts["sections"] = sections_of(collapse, details);
  write_page(out, collapse.title, picture, verdict_of(collapse),
             details.warnings, std::move(parts));
}

void write_report(std::ostream &out, const DrawingRefused &refused)
{
  const std::string message = refused.what();
  const std::size_t first_line = message.find('\n');
  const Picture picture = picture_of(refused.check);
  PageParts parts = page_data_of(picture);
  if (first_line != message.npos)
    parts["sections"] = "<section><h2>Faults</h2>\n<pre class=\"faults\">" +
                        html_text(message.substr(first_line + 1)) +
                        "</pre></section>";
  else
    parts["sections"] = "";
  write_page(out, "Check of a drawing", picture,
             {"collapse", message.substr(0, first_line), {}, {}}, {},
             std::move(parts));
}
} // namespace Voussoir
