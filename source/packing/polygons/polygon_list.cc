// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/base/text_file.h>
#include <voussoir/packing/group_names.h>
#include <voussoir/packing/polygons/polygon_list.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace Voussoir
{
namespace
{
/** Number the names of the groups in the order in which they appear. */
void name_groups(const PolygonList &polygons, CellLoops &cells)
{
  const auto unnamed = [](const PolygonList::Polygon &polygon) {
    return polygon.group.empty();
  };
  if (std::all_of(polygons.polygons.begin(), polygons.polygons.end(), unnamed))
    return;
  std::map<std::string, unsigned int> numbers;
  for (const PolygonList::Polygon &polygon : polygons.polygons)
  {
    const std::string &name = unnamed(polygon) ? "block" : polygon.group;
    const auto entry = numbers.emplace(name, cells.group_names.size());
    if (entry.second)
      cells.group_names.push_back(name);
    cells.group.push_back(entry.first->second);
  }
}
} // namespace

bool PolygonList::Polygon::is_finite() const
{
  return std::all_of(ring.begin(), ring.end(), [](const dealii::Point<2> &p) {
    return std::isfinite(p[0]) && std::isfinite(p[1]);
  });
}

bool PolygonList::Polygon::is_drawable() const
{
  return ring.size() > 2 && is_finite();
}

DrawingFault PolygonList::fault(const DrawingFault::Kind kind,
                                const unsigned int cell,
                                const unsigned int record,
                                const std::string &fault,
                                const std::string &detail) const
{
  return {kind,
          {cell},
          text("Cell ", cell, " (", named(record, detail, true), ") ", fault)};
}

std::string PolygonList::record_of(const unsigned int cell,
                                   const bool with_file) const
{
  return named(polygons[cell].record, polygons[cell].detail, with_file);
}

std::string PolygonList::named(const unsigned int record,
                               const std::string &detail,
                               const bool with_file) const
{
  return text(record_name, ' ', record,
              with_file ? " of '" + file.string() + "'" : "",
              detail.empty() ? "" : ", ", detail);
}

void PolygonList::refuse_faults() const
{
  if (faults.empty())
    return;
  DrawingCheck check;
  for (const Polygon &polygon : polygons)
    check.rings.push_back(polygon.is_drawable() && !polygon.is_open
                              ? polygon.ring
                              : decltype(polygon.ring)());
  check.faults = faults;
  throw DrawingRefused(file.string(), std::move(check));
}

CellLoops loops_of(const PolygonList &polygons)
{
  CellLoops loops;
  std::map<std::pair<double, double>, unsigned int> numbers;
  for (const PolygonList::Polygon &polygon : polygons.polygons)
  {
    std::vector<unsigned int> loop;
    if (!polygon.is_broken)
      for (const dealii::Point<2> &p : polygon.ring)
      {
        const auto [entry, is_new] =
            numbers.emplace(std::make_pair(p[0], p[1]), loops.vertices.size());
        if (is_new)
          loops.vertices.push_back(p);
        loop.push_back(entry->second);
      }
    loops.add(loop);
  }
  return loops;
}

void check_group_names(PolygonList &polygons)
{
  for (unsigned int c = 0; c < polygons.polygons.size(); ++c)
    polygons.passes([&] {
      const std::string &name = polygons.polygons[c].group;
      const std::string fault = name.empty() ? "" : fault_of_group_name(name);
      if (!fault.empty())
        polygons.refuse(DrawingFault::Kind::bad_group_name, c,
                        "belongs to the group " + quoted_group_name(name) +
                            ", whose name " + fault + "; rename it.");
    });
}

void hand_on_records(const PolygonList &polygons, CellLoops &cells)
{
  name_groups(polygons, cells);
  cells.file = polygons.file.string();
  for (const PolygonList::Polygon &polygon : polygons.polygons)
  {
    cells.records.push_back(polygon.record);
    if (!polygon.detail.empty())
    {
      cells.details.resize(cells.records.size());
      cells.details.back() = polygon.detail;
    }
  }
  cells.record_name = polygons.record_name;
  cells.notices.insert(cells.notices.begin(), polygons.notices.begin(),
                       polygons.notices.end());
}

std::string read_polygon_text(const std::filesystem::path &file)
{
  std::optional<std::string> text = read_text_file(file);
  if (!text)
    throw InputError("The file of polygons '" + file.string() +
                     "' cannot be read. Paths in a .prm file start at the "
                     "directory of that file.");
  return std::move(*text);
}
} // namespace Voussoir
