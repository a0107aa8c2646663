// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/packing/polygons/drawing_faults.h>

#include <algorithm>
#include <map>

namespace Voussoir
{
namespace
{
using Kind = DrawingFault::Kind;

/** How many faults of a kind a message has in full. */
constexpr std::size_t most_shown = 10;

/** The heading of a list of faults. */
std::string heading(const Kind kind)
{
  switch (kind)
  {
  case Kind::no_polygon: return "no polygon";
  case Kind::not_closed: return "not closed";
  case Kind::hole: return "with a hole";
  case Kind::bad_vertex: return "bad vertices";
  case Kind::no_area: return "no area";
  case Kind::self_crossing: return "crossing itself";
  case Kind::sliver: return "slivers";
  case Kind::bad_group_name: return "names of groups";
  case Kind::too_small_to_match: return "too small for the matching tolerance";
  case Kind::duplicate: return "there twice";
  case Kind::overlap: return "overlaps";
  case Kind::impossible_joint: return "no joints";
  case Kind::floats: return "touching no other cell";
  case Kind::gap: break;
  }
  return "gaps";
}
} // namespace

std::string message_of(const std::string &file,
                       const std::vector<DrawingFault> &faults)
{
  if (faults.size() == 1)
    return faults.front().what();
  std::map<Kind, std::vector<const DrawingFault *>> by_kind;
  for (const DrawingFault &fault : faults)
    by_kind[fault.kind].push_back(&fault);
  const auto n_remarks = std::count_if(
      faults.begin(), faults.end(),
      [](const DrawingFault &fault) { return fault.kind >= Kind::floats; });
  std::string message =
      text("The drawing '", file, "' has ", faults.size() - n_remarks,
           " faults, which should be mended:");
  bool are_remarks = false;
  for (const auto &[kind, of_kind] : by_kind)
  {
    if (kind >= Kind::floats && !are_remarks)
      message += "\nIt also has what may be meant:";
    are_remarks |= kind >= Kind::floats;
    message += text("\n", heading(kind), " (", of_kind.size(), "):");
    for (std::size_t k = 0; k < std::min(of_kind.size(), most_shown); ++k)
      message += std::string("\n  ") + of_kind[k]->what();
    if (of_kind.size() > most_shown)
      message += text("\n  and ", of_kind.size() - most_shown, " more.");
  }
  return message;
}
} // namespace Voussoir
