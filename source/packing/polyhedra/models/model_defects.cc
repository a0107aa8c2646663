// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/group_names.h>
#include <voussoir/packing/polyhedra/models/model_defects.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace Voussoir
{
using DefectKind = ModelDefect::Kind;

namespace
{
/** The defects of one kind that a message names in full. */
constexpr unsigned int most_shown_of_kind = 5;

/** "face 3", "at (0, 0, 0)", or both. */
std::string place_in_block(const ModelDefect &defect)
{
  const std::string place = "at " + text_of_point(defect.place);
  return defect.face == dealii::numbers::invalid_unsigned_int
             ? place
             : text("face ", defect.face, ' ', place);
}

/** "the face 3 at (0, 0, 0)", or the first or the worst one of several. */
std::string one_of(const ModelDefect &defect, const std::string &which)
{
  return defect.count == 1 ? place_in_block(defect)
                           : which + ' ' + place_in_block(defect);
}

std::string upper_first(std::string sentence)
{
  sentence[0] = std::toupper(sentence[0]);
  return sentence;
}
} // namespace

std::string text_of(const DefectKind kind)
{
  switch (kind)
  {
  case DefectKind::skipped_entry:
    return "entries of a list that are no meshes, left out";
  case DefectKind::separate_parts:
    return "closed surfaces of one name, each made a cell";
  case DefectKind::unusable_name:
    return "names that no group can have, left out";
  case DefectKind::welded_vertex: return "vertices at one place, welded";
  case DefectKind::hanging_vertex:
    return "vertices within an edge of one face, added to the other";
  case DefectKind::repeated_vertex:
    return "faces with a vertex twice in a row, taken once";
  case DefectKind::degenerate_face:
    return "faces with less than three vertices, left out";
  case DefectKind::repeated_face: return "faces listed twice, taken once";
  case DefectKind::turned_face:
    return "faces that ran the wrong way round, turned";
  case DefectKind::joined_face:
    return "faces in the plane of a neighbour, joined to it";
  case DefectKind::straight_vertex:
    return "vertices within straight edges, left out";
  case DefectKind::bent_face:
    return "faces with vertices off their plane, kept";
  case DefectKind::overlap:
    return "blocks that penetrate others, kept without an interface there";
  case DefectKind::repeated_key: return "keys that are there twice";
  case DefectKind::no_mesh: return "blocks without a mesh";
  case DefectKind::other_shape: return "shapes that are no meshes";
  case DefectKind::unknown_element: return "elements that are not there";
  case DefectKind::repeated_element: return "elements that are placed twice";
  case DefectKind::bad_matrix: return "transformations that are no matrices";
  case DefectKind::projective_map:
    return "transformations that are projections";
  case DefectKind::singular_map: return "transformations that flatten";
  case DefectKind::bad_flag: return "marks that are neither true nor false";
  case DefectKind::bad_coordinate: return "coordinates that cannot be read";
  case DefectKind::missing_coordinate: return "coordinates that are missing";
  case DefectKind::bad_index: return "vertices that are no whole numbers";
  case DefectKind::unknown_vertex: return "vertices that are not there";
  case DefectKind::bad_face: return "faces that are no lists of vertices";
  case DefectKind::bad_half_edges: return "half-edges that are no loops";
  case DefectKind::no_face: return "blocks without faces";
  case DefectKind::bad_number: return "coordinates that are not finite";
  case DefectKind::bad_scale: return "blocks too large or too small";
  case DefectKind::open: return "edges of one face only";
  case DefectKind::gap: return "edges that miss each other";
  case DefectKind::branching: return "edges of more than two faces";
  case DefectKind::one_sided: return "surfaces without an inside";
  case DefectKind::few_faces: return "blocks of less than four faces";
  case DefectKind::no_volume: return "blocks without a volume";
  case DefectKind::flat_face: return "faces without an area";
  case DefectKind::crossing_face: return "faces that touch themselves";
  case DefectKind::bridged_face: return "faces around holes";
  case DefectKind::warped_face: return "faces without a plane";
  case DefectKind::crossing_surface: return "faces that cross others";
  case DefectKind::thin: return "blocks as thin as the tolerance";
  case DefectKind::repeated_block: return "blocks where others are";
  case DefectKind::enclosed_block: return "blocks inside of others";
  }
  return "";
}

std::string text_of(const ModelDefect &defect)
{
  const auto sentence = [&](const auto &...words) {
    return text(words..., '.');
  };
  switch (defect.kind)
  {
  case DefectKind::no_face:
    return "has no face with three different vertices; delete it.";
  case DefectKind::bad_number:
    return sentence("has ", defect.count == 1 ? "a vertex" : "vertices",
                    " with coordinates that are not finite, ",
                    one_of(defect, text(defect.count, ", the first")),
                    "; coordinates must be finite");
  case DefectKind::bad_scale:
    return sentence("at ", text_of_point(defect.place),
                    " is too large or too small for its volume to be a "
                    "number; choose another unit of length");
  case DefectKind::open:
    return sentence("is open: ", counted(defect.count, "edge"),
                    " of one face only, ", one_of(defect, "the first of"),
                    "; close the surface");
  case DefectKind::gap:
    return sentence("is open: ", counted(defect.count, "edge"), ", ",
                    one_of(defect, "the worst of"), ", ",
                    defect.count == 1 ? "misses" : "miss",
                    " the edge beside by up to ", defect.size,
                    ", more than the tolerance ", defect.detail,
                    "; move the vertices together, or raise 'Tolerance'");
  case DefectKind::branching:
    return sentence("has ", counted(defect.count, "edge"),
                    " of more than two faces, ", one_of(defect, "the first of"),
                    "; take away faces inside, or make blocks of what touches "
                    "there");
  case DefectKind::one_sided:
    return sentence("has no inside: ", place_in_block(defect),
                    " cannot be turned to agree with all its neighbours; "
                    "redraw it");
  case DefectKind::few_faces:
    return sentence("at ", text_of_point(defect.place), " has ",
                    counted(static_cast<std::size_t>(defect.size), "face"),
                    ", and a block has four at least; delete what is left "
                    "over, or add the faces that are missing");
  case DefectKind::no_volume:
    return sentence("at ", text_of_point(defect.place),
                    " encloses no volume; delete it, or give it all its faces");
  case DefectKind::flat_face:
    return sentence("has ", counted(defect.count, "face"), ", ",
                    one_of(defect, "the first"),
                    ", without an area; redraw or delete it");
  case DefectKind::crossing_face:
    return sentence("has ", counted(defect.count, "face"), ", ",
                    one_of(defect, "the first"),
                    ", with a loop that crosses or touches itself; draw it as "
                    "one that does neither, or cut it into several");
  case DefectKind::bridged_face:
    return sentence("has ", counted(defect.count, "edge"), ", ",
                    one_of(defect, "the first of"),
                    ", along which a face runs twice, as around a hole; cut it "
                    "into faces without holes");
  case DefectKind::warped_face:
    return sentence("has ", counted(defect.count, "face"), ", ",
                    one_of(defect, "the worst"), ", in no plane: vertices are ",
                    defect.size, " off it; cut it into triangles");
  case DefectKind::crossing_surface:
    return sentence("crosses itself in ", counted(defect.count, "place"), ", ",
                    one_of(defect, "the worst"), " over a length of ",
                    defect.size, "; redraw it");
  case DefectKind::thin:
    return sentence("at ", text_of_point(defect.place), " has the thickness ",
                    defect.size, ", which is less than twice the tolerance ",
                    defect.detail, "; lower 'Tolerance', or delete it");
  case DefectKind::repeated_block:
    return sentence("at ", text_of_point(defect.place), " is where ",
                    defect.detail, " is; delete one of them");
  case DefectKind::enclosed_block:
    return sentence("at ", text_of_point(defect.place), " is inside of ",
                    defect.detail,
                    "; delete one of them, or cut a block around a hollow into "
                    "several without");
  default: return sentence("has ", text_of(defect.kind), ": ", defect.count);
  }
}

CellDefect cell_defect(const ModelDefect &defect)
{
  const std::string words = text_of(defect.kind);
  const std::size_t comma = words.rfind(", ");
  return {static_cast<unsigned int>(defect.kind),
          words.substr(0, comma),
          comma == words.npos ? "" : words.substr(comma + 2),
          defect.cell,
          defect.count,
          defect.face,
          defect.size,
          defect.place,
          defect.detail};
}

std::string describe_named(const CellRecords &records, const unsigned int cell)
{
  std::string description = records.describe(cell);
  if (!records.group.empty())
    description.insert(
        text("cell ", cell).size(),
        ' ' + quoted_group_name(records.group_names[records.group[cell]]));
  return description;
}

std::vector<std::string> notices_of(const std::vector<ModelDefect> &defects,
                                    const CellRecords &records)
{
  struct Sum
  {
    unsigned int n_cells = 0, count = 0;
    const ModelDefect *worst = nullptr;
  };
  std::map<DefectKind, Sum> sums;
  for (const ModelDefect &defect : defects)
  {
    Sum &sum = sums[defect.kind];
    ++sum.n_cells;
    sum.count += defect.count;
    if (sum.worst == nullptr || defect.size > sum.worst->size)
      sum.worst = &defect;
  }
  std::vector<std::string> notices;
  for (const auto &[kind, sum] : sums)
  {
    const ModelDefect &worst = *sum.worst;
    if (kind == DefectKind::skipped_entry)
    {
      notices.push_back(upper_first(text_of(kind)) + text(": ", sum.count,
                                                          "; the first is ",
                                                          worst.detail, '.'));
      continue;
    }
    const std::string in_cell = " in " + describe_named(records, worst.cell);
    std::string notice =
        upper_first(text_of(kind)) +
        text(": ", sum.count, " in ", counted(sum.n_cells, "cell"), "; ");
    if (worst.size > 0.)
      notice += text("the largest distance, ", worst.size, ", is ",
                     place_in_block(worst), in_cell, '.');
    else if (kind == DefectKind::unusable_name)
      notice += "the first, " + worst.detail + ", is that of " +
                describe_named(records, worst.cell) + '.';
    else if (kind == DefectKind::separate_parts)
      notice += "the first is " + describe_named(records, worst.cell) + '.';
    else
      notice += "the first is " + place_in_block(worst) + in_cell + '.';
    notices.push_back(notice);
  }
  return notices;
}

void refuse_defects(const std::vector<ModelDefect> &defects,
                    const CellRecords &records)
{
  std::vector<std::string> lines;
  std::map<DefectKind, unsigned int> counts;
  unsigned int n_faults = 0;
  for (const ModelDefect &defect : defects)
    if (defect.is_refusal())
    {
      ++n_faults;
      if (++counts[defect.kind] <= most_shown_of_kind)
        lines.push_back(defect.is_of_file() ? defect.detail
                                            : upper_first(describe_named(
                                                  records, defect.cell)) +
                                                  ' ' + text_of(defect));
    }
  if (lines.empty())
    return;
  if (lines.size() == 1)
    throw InputError(lines[0]);
  for (const auto &[kind, count] : counts)
    if (count > most_shown_of_kind)
      lines.push_back(text("And ", count - most_shown_of_kind,
                           " more: ", text_of(kind), '.'));
  std::string message =
      text("The model '", records.file, "' has ", n_faults, " faults of ",
           counted(counts.size(), "kind"), ", which should be mended:");
  for (const std::string &line : lines)
    message += "\n  " + line;
  throw InputError(message);
}
} // namespace Voussoir
