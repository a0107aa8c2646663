// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/fields/polyhedra.h>
#include <voussoir/output/report/packing_report.h>
#include <voussoir/output/report/space_report.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>
#include <utility>

namespace Voussoir
{
namespace
{
/** The quantities of a table that are numbers, and the sizes of vectors, but
 * for those of @p others. */
std::vector<SpaceField> numbers_of(const FieldTable<SpaceResults> &table,
                                   const SpaceResults &answer,
                                   const std::size_t n,
                                   const std::set<std::string> &others)
{
  std::vector<SpaceField> fields;
  for (const Field<SpaceResults> &field : table.all())
  {
    const bool is_vector = field.shape == FieldShape::space_vector;
    if ((!is_vector && field.shape != FieldShape::number) ||
        others.count(field.name) > 0 || !field.holds(answer))
      continue;
    std::vector<double> values(n * field.n_components());
    field.bind(answer).values(0, n, values.data());
    if (is_vector)
      for (std::size_t k = 0; k < n; ++k)
        values[k] =
            std::hypot(values[3 * k], values[3 * k + 1], values[3 * k + 2]);
    values.resize(n);
    std::string name = field.name;
    std::replace(name.begin(), name.end(), '_', ' ');
    fields.push_back({std::move(name), field.unit, std::move(values)});
  }
  return fields;
}

/** The motion of all blocks; fixed ones are at rest. */
std::vector<SpaceReport::BlockMotion> motion_of(const SpaceResults &answer)
{
  const Packing<3> &packing = answer.scene.packing();
  std::vector<SpaceReport::BlockMotion> motion(packing.polyhedra().n_cells());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    motion[c].displacement =
        answer.motion.at(c, packing.moments(c).centroid - packing.centre(c));
    if (!answer.motion.rotation.empty())
      motion[c].rotation = answer.motion.rotation[c];
  }
  return motion;
}

/** What was found, for the table below the picture. */
void add_answer(const SpaceResults &answer, SpaceReport &report)
{
  const auto add = [&](const std::string &label, const std::string &value) {
    report.summary.emplace_back(label, value);
  };
  add("Answer", answer.status.description());
  if (!answer.message.empty())
    add("Not carried", answer.message);
  if (answer.summary.contains("load_factor"))
    add("Load factor", answer.summary["load_factor"]["meaning"]);
  for (const auto &[title, line] : answer.lines)
    add(title, line);
  if (!answer.is_carried())
    return;
  add("Balance of forces",
      text(answer.certificate.equilibrium_residual, " of the largest load"));
  if (answer.scene.blocks->turns())
    add("Balance of moments",
        text(answer.certificate.moment_residual, " of the largest load"));
  add("Beyond limits",
      text(answer.certificate.admissibility_violation, " of the largest load"));
}
} // namespace

void write_packing_report(std::ostream &out,
                          const SpaceResults &answer,
                          const std::string &title,
                          const std::vector<std::string> &warnings,
                          const std::vector<CellDefect> &defects)
{
  const Packing<3> &packing = answer.scene.packing();
  const FaceContacts contacts = packing.contacts();
  const CellFaces &cells = packing.polyhedra();
  SpaceReport report;
  report.title = title;
  report.cells = &cells;
  report.contacts = &contacts;
  report.cell_fields = numbers_of(polyhedron_fields(), answer, cells.n_cells(),
                                  {"cell", "group", "fixed", "centre"});
  report.contact_fields =
      numbers_of(face_interface_fields(), answer, packing.interfaces().size(),
                 {"cell_minus", "cell_plus", "support", "centroid", "normal"});
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
  if (answer.is_analysed)
    add_answer(answer, report);
  if (answer.clamping)
    report.summary.emplace_back("Clamping", answer.clamping->words);
  if (!answer.motion.displacement.empty())
    report.motion = motion_of(answer);
  report.collapses = answer.status.kind == Status::Kind::collapse;
  report.warnings = warnings;
  report.defects = defects;
  write_space_report(out, report);
}
} // namespace Voussoir
