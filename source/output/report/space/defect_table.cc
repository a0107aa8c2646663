// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/invalid_index.h>
#include <voussoir/base/text.h>
#include <voussoir/output/report/html_table.h>
#include <voussoir/output/report/space/defect_table.h>
#include <voussoir/packing/polyhedra/models/model_defects.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace Voussoir
{
namespace
{
/** The rows of one kind that the table has. */
constexpr unsigned int most_rows_of_kind = 10;

/** Defects by kind, then the largest first; they keep their order else. */
std::vector<CellDefect> sorted_by_size(std::vector<CellDefect> defects)
{
  std::stable_sort(defects.begin(), defects.end(),
                   [](const CellDefect &a, const CellDefect &b) {
                     return std::make_tuple(a.kind, -a.size) <
                            std::make_tuple(b.kind, -b.size);
                   });
  return defects;
}

std::string block_of_defect(const CellFaces &cells, const CellDefect &defect)
{
  if (defect.cell >= cells.n_cells())
    return html_text(defect.detail);
  std::string block = describe_named(cells, defect.cell);
  if (!defect.detail.empty())
    block += ", " + defect.detail;
  return html_text(block);
}
} // namespace

std::string html_of_defects(const CellFaces &cells,
                            const std::vector<CellDefect> &defects)
{
  if (defects.empty())
    return "";
  HtmlTable table(
      "defects", "Defects of blocks",
      {"Kind", "Block", "How many", "Face", "Size", "Place", "What was done"});
  std::map<unsigned int, unsigned int> counts, shown;
  for (const CellDefect &defect : defects)
    ++counts[defect.kind];
  for (const CellDefect &defect : sorted_by_size(defects))
  {
    const unsigned int row = ++shown[defect.kind];
    if (row <= most_rows_of_kind)
      table.row({html_text(defect.what), block_of_defect(cells, defect),
                 text(defect.count),
                 defect.face == invalid_index ? "" : text(defect.face),
                 defect.size > 0. ? text(defect.size) : "",
                 defect.has_place() ? text_of_point(defect.place) : "",
                 html_text(defect.action)});
    else if (row == most_rows_of_kind + 1)
      table.row({html_text(defect.what),
                 "and " + counted(counts[defect.kind] - most_rows_of_kind,
                                  "more block"),
                 "", "", "", "", html_text(defect.action)});
  }
  return table.close();
}
} // namespace Voussoir
