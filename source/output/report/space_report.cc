// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/report/details.h>
#include <voussoir/output/report/html_table.h>
#include <voussoir/output/report/page_parts.h>
#include <voussoir/output/report/space/defect_table.h>
#include <voussoir/output/report/space/space_data.h>
#include <voussoir/output/report/space/space_picture.h>
#include <voussoir/output/report/space_report.h>
#include <voussoir/report_page.h>
#include <voussoir/space_page.h>
#include <voussoir/version.h>

#include <ostream>

namespace Voussoir
{
namespace
{
/** The scales of fields; @p n values count, from the first on. */
std::vector<ColourScale> scales_of(const std::vector<SpaceField> &fields,
                                   const std::size_t n,
                                   const std::string &letter)
{
  std::vector<ColourScale> scales;
  for (std::size_t k = 0; k < fields.size(); ++k)
    scales.emplace_back(text(letter, k, 's'),
                        std::vector<double>(fields[k].values.begin(),
                                            fields[k].values.begin() + n));
  return scales;
}

/** The buttons, legends and rules of CSS of all ways to colour the blocks. */
class ColourChoices
{
public:
  /**
   * Add one, of which a button has the name.
   *
   * @param classes of the button.
   */
  void add(const std::string &name,
           const std::string &legend,
           const std::string &classes = "of-blocks")
  {
    const std::string id = text("colour-", n++);
    buttons += "<input type=\"radio\" name=\"colour\" id=\"" + id +
               "\" class=\"" + classes + '"' + (n == 1 ? " checked" : "") +
               "><label for=\"" + id + "\" class=\"" + classes + "\">" +
               html_text(name) + "</label>";
    legends += "<div class=\"legend of-" + id + "\">" + legend + "</div>\n";
    style += '#' + id + ":checked ~ .sheet .of-" + id + "{display:block}\n";
  }
  /** Add a field of blocks with its scale, which colours the picture, too. */
  void add_blocks(const SpaceField &field, const ColourScale &scale)
  {
    style += scale.rules(text("#colour-", n, ":checked ~ .sheet"));
    add(field.name, scale.legend(UnitNames::labelled(field.name, field.unit)));
  }
  /** Add a field of joints with its scale. */
  void add_joints(const SpaceField &field, const ColourScale &scale)
  {
    add(field.name, scale.legend(UnitNames::labelled(field.name, field.unit)),
        "of-joints");
  }

  /** HTML, and CSS the last. */
  std::string buttons, legends, style = light_rules();

private:
  /** The number of ways so far. */
  unsigned int n = 0;
};

std::string legend_of_blocks(const SpaceReport &report)
{
  const CellFaces &cells = *report.cells;
  std::string html =
      "<p>" + counted(cells.n_cells() - cells.n_fixed, "block") + ", " +
      counted(report.contacts ? report.contacts->faces.size() : 0, "joint") +
      "</p>";
  if (cells.n_fixed > 0)
    html += "<p><span class=\"swatch of-fixed\"></span> " +
            text(cells.n_fixed) + " fixed</p>";
  return html;
}

/** The picture as SVG, or why there is none. */
std::string html_of_picture(const SpaceReport &report,
                            const std::vector<ColourScale> &scales)
{
  const std::vector<unsigned int> faces =
      faces_in_picture(*report.cells, report.contacts);
  if (faces.empty())
    return "<p id=\"drawing\" class=\"none\">There are no blocks.</p>";
  if (faces.size() > most_faces_in_picture)
    return text("<p id=\"drawing\" class=\"none\">The picture would have ",
                faces.size(), " faces, more than ", most_faces_in_picture,
                ": it is left out.</p>");
  const Drawing drawing = space_picture(report, faces, scales);
  return "<svg id=\"drawing\" viewBox=\"" + drawing.view_box() +
         "\" role=\"img\" aria-label=\"isometric picture\">\n" +
         drawing.elements() + "</svg>";
}

std::string html_of_sections(const SpaceReport &report)
{
  std::string html;
  if (!report.summary.empty())
  {
    HtmlTable table("summary", "Summary");
    for (const auto &[label, value] : report.summary)
      table.row({html_text(label), html_text(value)});
    html += table.close();
  }
  if (!report.warnings.empty())
  {
    HtmlTable table("warnings", "Warnings");
    for (std::size_t k = 0; k < report.warnings.size(); ++k)
      table.row({text(k + 1), html_text(report.warnings[k])});
    html += table.close();
  }
  return html + html_of_defects(*report.cells, report.defects);
}
} // namespace

void write_space_report(std::ostream &out, const SpaceReport &report)
{
  check_content(report);
  const CellFaces &cells = *report.cells;
  const std::vector<ColourScale> of_cells =
      scales_of(report.cell_fields, cells.n_cells() - cells.n_fixed, "c");
  const std::vector<ColourScale> of_joints =
      scales_of(report.contact_fields,
                report.contacts ? report.contacts->faces.size() : 0, "j");
  ColourChoices choices;
  choices.add("Blocks", legend_of_blocks(report));
  for (std::size_t k = 0; k < of_cells.size(); ++k)
    choices.add_blocks(report.cell_fields[k], of_cells[k]);
  for (std::size_t k = 0; k < of_joints.size(); ++k)
    choices.add_joints(report.contact_fields[k], of_joints[k]);

  PageParts parts;
  parts["title"] = html_text(report.title.empty() ? "Voussoir" : report.title);
  parts["version"] = VOUSSOIR_VERSION;
  parts["css"] = page_css;
  parts["space_css"] = space_page_css;
  parts["style"] = choices.style;
  parts["switch"] = choices.buttons;
  parts["legends"] = choices.legends;
  parts["picture"] = html_of_picture(report, of_cells);
  parts["sections"] = html_of_sections(report);
  parts["data"] = space_data(report, of_cells, of_joints);
  parts["shaders_js"] = space_shaders_js;
  parts["view_js"] = space_view_js;
  parts["controls_js"] = space_controls_js;
  parts["js"] = space_page_js;
  fill_page(out, space_page_html, parts);
}
} // namespace Voussoir
