// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/fields/polyhedra.h>
#include <voussoir/output/report/packing_report.h>
#include <voussoir/output/report/space_report.h>

#include <ostream>
#include <set>

namespace Voussoir
{
namespace
{
/** The quantities of a table that are numbers, but for those of @p others. */
std::vector<SpaceField> numbers_of(const FieldTable<Packing<3>> &table,
                                   const Packing<3> &packing,
                                   const std::size_t n,
                                   const std::set<std::string> &others)
{
  std::vector<SpaceField> fields;
  for (const Field<Packing<3>> &field : table.all())
    if (field.shape == FieldShape::number && others.count(field.name) == 0)
      fields.push_back(
          {field.name, field.unit, table.values(field.name, packing, n)});
  return fields;
}
} // namespace

void write_packing_report(std::ostream &out,
                          const Packing<3> &packing,
                          const std::string &title,
                          const std::vector<std::string> &warnings,
                          const std::vector<CellDefect> &defects)
{
  const FaceContacts contacts = packing.contacts();
  const CellFaces &cells = packing.polyhedra();
  SpaceReport report;
  report.title = title;
  report.cells = &cells;
  report.contacts = &contacts;
  report.cell_fields = numbers_of(polyhedron_fields(), packing, cells.n_cells(),
                                  {"cell", "group", "fixed"});
  report.contact_fields =
      numbers_of(face_interface_fields(), packing, packing.interfaces().size(),
                 {"cell_minus", "cell_plus", "support"});
  const dealii::BoundingBox<3> box = packing.box();
  report.summary = {
      {"Blocks", text(packing.n_cells())},
      {"Fixed blocks", text(cells.n_fixed)},
      {"Interfaces", text(packing.interfaces().size())},
      {"Supports", text(packing.n_supports())},
      {"Extent", text(box.side_length(0), " x ", box.side_length(1), " x ",
                      box.side_length(2))},
      {"Volume", text(packing.volume())},
      {"Blocks that are not convex", text(packing.not_convex().size())}};
  report.warnings = warnings;
  report.defects = defects;
  write_space_report(out, report);
}
} // namespace Voussoir
