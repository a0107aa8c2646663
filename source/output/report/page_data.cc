// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/csv.h>
#include <voussoir/output/csv_table.h>
#include <voussoir/output/fields/tables.h>
#include <voussoir/output/report/page_data.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <sstream>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

/** Text of an element that holds no HTML: nothing in it may end the element. */
std::string harmless(std::string words)
{
  std::replace(words.begin(), words.end(), '<', '(');
  return words;
}

template <typename Writer>
std::string table(const Writer &writer)
{
  std::ostringstream out;
  writer(out);
  return harmless(out.str());
}

/** A table of the quantities with these names alone. */
std::string table(const BoundFields &all,
                  const std::set<std::string> &names,
                  const unsigned int n)
{
  BoundFields wanted;
  std::copy_if(all.begin(), all.end(), std::back_inserter(wanted),
               [&](const BoundField &field) {
                 return names.count(field.about->name) > 0;
               });
  return table([&](std::ostream &out) { write_table(out, wanted, n); });
}

Json json_of(const Picture &picture, const UnitNames &names)
{
  const dealii::Point<2> origin = picture.drawing.origin();
  Json json = {{"length", picture.drawing.length_of_unit()},
               {"origin", {origin[0], origin[1]}},
               {"units", {{"length", names.length}, {"force", names.force}}}};
  json["units"]["stress"] = names.stress;
  if (const auto &motion = picture.motion)
    json["motion"] = {{"factor", motion->factor},
                      {"most", motion->most},
                      {"largest", motion->largest},
                      {"hasSize", motion->has_size}};
  return json;
}

/** Without any table. */
PageParts without_tables(const Picture &picture, const UnitNames &names)
{
  return {{"data", harmless(json_of(picture, names).dump())},
          {"blocks", ""},
          {"joints", ""},
          {"links", ""},
          {"motion", ""},
          {"jumps", ""},
          {"hint", ""}};
}

/** What all runs have: nothing but a hint, or one that tells of numbers. */
PageParts
begin(const RunRecord &run, const Picture &picture, const UnitNames &names)
{
  PageParts parts = without_tables(picture, names);
  parts["hint"] = is_in_full(run)
                      ? "Point at a block, a joint or a tie for its numbers; "
                        "click to keep them."
                      : "There are too many blocks for their numbers.";
  return parts;
}

/** True if the files of the results have the motion. */
bool has_motion(const Results &results, const Motion &motion)
{
  return results.motion.displacement == motion.displacement &&
         results.motion.rotation == motion.rotation;
}
} // namespace

bool is_in_full(const RunRecord &run)
{
  return run.scene.packing.n_cells() <= most_cells_in_full;
}

PageParts page_data_of(const Results &results,
                       const Picture &picture,
                       const UnitNames &names)
{
  PageParts parts = begin(results, picture, names);
  if (!is_in_full(results))
    return parts;
  const Scene &scene = results.scene;
  parts["blocks"] =
      table([&](std::ostream &csv) { write_cells_csv(csv, results); });
  parts["joints"] =
      table([&](std::ostream &csv) { write_interfaces_csv(csv, results); });
  if (!scene.links.empty())
    parts["links"] =
        table([&](std::ostream &csv) { write_links_csv(csv, results); });
  if (!picture.motion)
    return parts;
  const MovingScene moving(scene, *picture.motion->motion);
  if (!has_motion(results, moving.motion))
    parts["motion"] =
        table(mechanism_fields().columns(moving), {"displacement", "rotation"},
              scene.packing.n_cells());
  parts["jumps"] = table(mechanism_joint_fields().columns(moving),
                         {"opening", "sliding", "openings"},
                         scene.packing.interfaces().size());
  return parts;
}

PageParts page_data_of(const Collapse &collapse,
                       const Picture &picture,
                       const UnitNames &names)
{
  PageParts parts = begin(collapse, picture, names);
  if (!is_in_full(collapse))
    return parts;
  const Scene &scene = collapse.scene;
  parts["blocks"] = table([&](std::ostream &csv) {
    write_mechanism_csv(csv, scene, collapse.motion);
  });
  parts["joints"] = table([&](std::ostream &csv) {
    write_mechanism_joints_csv(csv, scene, collapse.motion);
  });
  if (!scene.links.empty())
    parts["links"] = table([&](std::ostream &csv) {
      write_mechanism_links_csv(csv, scene, collapse.motion);
    });
  return parts;
}

PageParts page_data_of(const Picture &picture)
{
  return without_tables(picture, {});
}
} // namespace Voussoir
