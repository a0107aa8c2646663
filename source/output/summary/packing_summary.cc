// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/summary/packing_summary.h>
#include <voussoir/output/summary/versions.h>
#include <voussoir/packing/connected_groups.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <ostream>
#include <set>
#include <utility>

namespace Voussoir
{
using Json = nlohmann::ordered_json;

namespace
{
/** The kinds of defects: of how many blocks, how many, and the largest size. */
Json json_of_kinds(const std::vector<CellDefect> &defects)
{
  std::map<unsigned int, Json> kinds;
  for (const CellDefect &defect : defects)
  {
    Json &kind = kinds[defect.kind];
    if (kind.is_null())
      kind = {{"kind", defect.kind},
              {"what", defect.what},
              {"action", defect.action},
              {"blocks", 0},
              {"count", 0},
              {"largest_size", 0.}};
    kind["blocks"] = kind["blocks"].get<unsigned int>() + 1;
    kind["count"] = kind["count"].get<unsigned int>() + defect.count;
    kind["largest_size"] =
        std::max(kind["largest_size"].get<double>(), defect.size);
  }
  Json list = Json::array();
  for (const auto &[number, kind] : kinds)
    list.push_back(kind);
  return list;
}

/** The number of pairs of cells, or of a cell and the ground, that touch. */
std::size_t n_touching_pairs(const Packing<3> &packing)
{
  std::set<std::pair<unsigned int, unsigned int>> pairs;
  for (const Packing<3>::Interface &i : packing.interfaces())
    pairs.emplace(i.cell_minus,
                  i.fixed_cell != invalid_index ? i.fixed_cell : i.cell_plus);
  return pairs.size();
}

/** The number of groups of cells that touch neither others nor the ground. */
unsigned int n_without_ground(const Packing<3> &packing)
{
  const std::vector<unsigned int> lowest = connected_groups(packing);
  unsigned int n = 0;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    n += lowest[c] == c && lowest[packing.ground()] != c;
  return n;
}

/** The area of the supports; L^2. */
double supported_area(const Packing<3> &packing)
{
  double area = 0.;
  for (const Packing<3>::Interface &i : packing.interfaces())
    if (i.cell_plus == packing.ground())
      area += i.area;
  return area;
}
} // namespace

void show_packing(Terminal &terminal, const Packing<3> &packing)
{
  const dealii::BoundingBox<3> box = packing.box();
  const unsigned int n_fixed = packing.polyhedra().n_fixed;
  terminal.stage(
      "Packing",
      text(counted(packing.n_cells(), "cell"),
           n_fixed > 0 ? text(" and ", n_fixed, " that do not move") : "", ", ",
           counted(packing.interfaces().size(), "interface"), " in ",
           counted(n_touching_pairs(packing), "pair"), ", ",
           packing.n_supports(), " of them supports, ",
           counted(packing.boundary_faces().size(), "boundary face"), ", on ",
           box.side_length(0), " x ", box.side_length(1), " x ",
           box.side_length(2)));
  terminal.stage("Volume", text(packing.volume()));
  if (packing.n_supports() > 0)
    terminal.stage("Supports", text("with the area ", supported_area(packing)));
  const unsigned int n_free = n_without_ground(packing);
  if (n_free > 0)
    terminal.stage("Groups",
                   text(counted(n_free, "connected group"),
                        n_free == 1 ? " touches" : " touch", " no support"));
  const auto &concave = packing.not_convex();
  if (!concave.empty())
    terminal.stage("Not convex",
                   text(counted(concave.size(), "block"), "; the first is ",
                        packing.describe(concave.front())));
}

void write_summary_json(std::ostream &out,
                        const Packing<3> &packing,
                        const std::string &title,
                        const std::vector<CellDefect> &defects)
{
  std::vector<unsigned int> sizes(packing.group_names().size(), 0);
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    ++sizes[packing.group(c)];
  Json groups = Json::array();
  for (unsigned int g = 0; g + 1 < sizes.size(); ++g)
    groups.push_back({{"name", packing.group_names()[g]}, {"cells", sizes[g]}});
  const dealii::BoundingBox<3> box = packing.box();
  Json summary;
  summary["title"] = title;
  summary["status"] = "packing";
  summary["dimension"] = 3;
  summary["packing"] = {
      {"cells", packing.n_cells()},
      {"fixed_cells", packing.polyhedra().n_fixed},
      {"interfaces", packing.interfaces().size()},
      {"pairs", n_touching_pairs(packing)},
      {"supports", packing.n_supports()},
      {"boundary_faces", packing.boundary_faces().size()},
      {"extent", {box.side_length(0), box.side_length(1), box.side_length(2)}},
      {"volume", packing.volume()},
      {"supported_area", supported_area(packing)},
      {"not_convex", packing.not_convex().size()},
      {"groups_without_support", n_without_ground(packing)},
      {"groups", groups},
      {"notices", packing.notices()},
      {"defects", json_of_kinds(defects)}};
  summary["versions"] = library_versions();
  out << summary.dump(2) << '\n';
}
} // namespace Voussoir
