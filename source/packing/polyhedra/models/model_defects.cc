// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/models/model_defects.h>

#include <algorithm>
#include <map>

namespace Voussoir
{
using Kind = ModelDefect::Kind;

namespace
{
/** The defects that a message names in full. */
constexpr std::size_t most_defects_shown = 20;

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

std::string text_of(const Kind kind)
{
  switch (kind)
  {
  case Kind::separate_parts:
    return "separate closed surfaces in one block, each made a cell";
  case Kind::unusable_name:
    return "names that no group can have, left out";
  case Kind::welded_vertex: return "vertices at one place, welded";
  case Kind::repeated_vertex:
    return "faces with a vertex twice in a row, taken once";
  case Kind::degenerate_face:
    return "faces with less than three vertices, left out";
  case Kind::repeated_face: return "faces listed twice, taken once";
  case Kind::turned_face: return "faces that ran the wrong way round, turned";
  case Kind::joined_face:
    return "faces in the plane of a neighbour, joined to it";
  case Kind::straight_vertex: return "vertices within straight edges, left out";
  case Kind::bent_face: return "faces with vertices off their plane, kept";
  case Kind::no_face: return "blocks without faces";
  case Kind::bad_number: return "coordinates that are no numbers";
  case Kind::bad_scale: return "blocks too large or too small";
  case Kind::open: return "edges of one face only";
  case Kind::branching: return "edges of more than two faces";
  case Kind::one_sided: return "surfaces without an inside";
  case Kind::no_volume: return "blocks without a volume";
  case Kind::flat_face: return "faces without an area";
  case Kind::crossing_face: return "faces that touch themselves";
  case Kind::warped_face: return "faces without a plane";
  case Kind::crossing_surface: return "faces that cross others";
  case Kind::thin: return "blocks as thin as the tolerance";
  case Kind::repeated_block: return "blocks where others are";
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
  case Kind::no_face:
    return "has no face with three different vertices; delete it.";
  case Kind::bad_number:
    return sentence("has ", counted(defect.count, "vertex coordinate"),
                    " that are not finite, ", one_of(defect, "the first"),
                    "; coordinates must be finite");
  case Kind::bad_scale:
    return sentence("at ", text_of_point(defect.place),
                    " is too large or too small for its volume to be a "
                    "number; choose another unit of length");
  case Kind::open:
    return sentence("is open: it has ", counted(defect.count, "edge"),
                    " of one face only, ", one_of(defect, "the first of"),
                    "; close the surface");
  case Kind::branching:
    return sentence("has ", counted(defect.count, "edge"),
                    " of more than two faces, ", one_of(defect, "the first of"),
                    "; take away faces inside, or separate what touches there "
                    "into blocks");
  case Kind::one_sided:
    return sentence("has no inside: ", place_in_block(defect),
                    " cannot be turned to agree with all its neighbours; "
                    "redraw it");
  case Kind::no_volume:
    return sentence("at ", text_of_point(defect.place),
                    " has no volume: it is flat; delete it");
  case Kind::flat_face:
    return sentence("has ", counted(defect.count, "face"),
                    " without an area, ", one_of(defect, "the first"),
                    "; delete the vertices between the ends of it");
  case Kind::crossing_face:
    return sentence("has ", counted(defect.count, "face"),
                    " that cross or touch themselves, ",
                    one_of(defect, "the first"),
                    "; draw each as one loop that does neither, or cut it into "
                    "several");
  case Kind::warped_face:
    return sentence("has ", counted(defect.count, "face"),
                    " that are in no plane, by ", defect.size, ", ",
                    one_of(defect, "the worst"), "; cut it into triangles");
  case Kind::crossing_surface:
    return sentence("crosses itself in ", counted(defect.count, "place"),
                    ", over a length of ", defect.size, ' ',
                    one_of(defect, "in the worst"), "; redraw it");
  case Kind::thin:
    return sentence("at ", text_of_point(defect.place), " has the thickness ",
                    defect.size,
                    ", which is less than twice the tolerance ", defect.detail,
                    "; lower 'Tolerance', or delete it");
  case Kind::repeated_block:
    return sentence("at ", text_of_point(defect.place), " is where ",
                    defect.detail, " is; delete one of them");
  default:
    return sentence("has ", text_of(defect.kind), ": ", defect.count);
  }
}

std::vector<std::string> notices_of(const std::vector<ModelDefect> &defects,
                                    const CellRecords &records)
{
  struct Sum
  {
    unsigned int n_cells = 0, count = 0;
    const ModelDefect *worst = nullptr;
  };
  std::map<Kind, Sum> sums;
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
    const std::string in_cell = " in " + records.describe(worst.cell);
    std::string notice =
        upper_first(text_of(kind)) +
        text(": ", sum.count, " in ", counted(sum.n_cells, "cell"), "; ");
    if (worst.size > 0.)
      notice += text("the largest distance, ", worst.size, ", is ",
                     place_in_block(worst), in_cell, '.');
    else if (kind == Kind::unusable_name)
      notice += "the first, " + worst.detail + ", is that of " +
                records.describe(worst.cell) + '.';
    else if (kind == Kind::separate_parts)
      notice += "the first is " + records.describe(worst.cell) + '.';
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
  for (const ModelDefect &defect : defects)
    if (defect.is_refusal())
      lines.push_back(upper_first(records.describe(defect.cell)) + ' ' +
                      text_of(defect));
  if (lines.empty())
    return;
  if (lines.size() == 1)
    throw InputError(lines[0]);
  std::string message = text("The model '", records.file, "' has ",
                             lines.size(), " faults, which should be mended:");
  for (std::size_t k = 0; k < std::min(lines.size(), most_defects_shown); ++k)
    message += "\n  " + lines[k];
  if (lines.size() > most_defects_shown)
    message += text("\n  and ", lines.size() - most_defects_shown, " more.");
  throw InputError(message);
}
} // namespace Voussoir
