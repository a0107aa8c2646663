// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/summary/kernel_summary.h>
#include <voussoir/output/summary/packing_summary.h>
#include <voussoir/output/summary/provenance.h>
#include <voussoir/output/summary/space_ground_summary.h>
#include <voussoir/output/summary/space_stress_summary.h>
#include <voussoir/output/summary/versions.h>
#include <voussoir/packing/connected_groups.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
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
  show_faster_kernel(terminal, packing.n_cells());
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

namespace
{

Json json_of_vector(const dealii::Tensor<1, 3> &v)
{
  return {v[0], v[1], v[2]};
}

/** What was found, of blocks under loads. */
void add_answer(const SpaceResults &answer, Json &summary)
{
  const SpaceScene &scene = answer.scene;
  const Strengths &strengths = scene.blocks->strengths;
  summary["rotations"] = scene.blocks->turns();
  summary["friction_law"] = strengths.law;
  dealii::Tensor<1, 3> force, moment;
  double size = 0.;
  for (unsigned int c = 0; c < scene.packing().n_cells(); ++c)
  {
    force += scene.loads.force[c];
    moment += scene.loads.torque[c] +
              cross_product_3d(scene.packing().centre(c), scene.loads.force[c]);
    size += scene.loads.size[c];
  }
  summary["loads"] = {{"force", json_of_vector(force)},
                      {"moment_about_origin", json_of_vector(moment)},
                      {"size", size}};
  for (const auto &[name, value] : answer.summary.items())
    summary[name] = value;
  if (answer.is_carried())
  {
    const Certificate &of = answer.certificate;
    summary["certificate"] = {
        {"equilibrium_residual", of.equilibrium_residual},
        {"moment_residual", of.moment_residual},
        {"admissibility_violation", of.admissibility_violation},
        {"max_utilisation", of.max_utilisation}};
    dealii::Tensor<1, 3> on_ground;
    for (const SpaceReaction &reaction : answer.reactions)
      on_ground -= reaction.force;
    summary["force_on_ground"] = json_of_vector(on_ground);
    summary["reactions"] = json_of_reactions(answer);
    if (!answer.mean_stresses.empty())
      summary["stress"] = json_of_stress(answer);
  }
  else if (answer.is_mechanism)
    summary["mechanism"] = {
        {"closing_violation", answer.proof.closing_violation},
        {"work_over_dissipation", answer.proof.work_over_dissipation}};
}
} // namespace

Json summary_of(const SpaceResults &answer,
                const std::vector<CellDefect> &defects)
{
  const Packing<3> &packing = answer.scene.packing();
  std::vector<unsigned int> sizes(packing.group_names().size(), 0);
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    ++sizes[packing.group(c)];
  Json groups = Json::array();
  for (unsigned int g = 0; g + 1 < sizes.size(); ++g)
    groups.push_back({{"name", packing.group_names()[g]}, {"cells", sizes[g]}});
  const dealii::BoundingBox<3> box = packing.box();
  Json summary;
  summary["status"] = answer.is_analysed ? answer.status.word() : "packing";
  if (answer.status.kind == Status::Kind::carried_within)
    summary["within"] = answer.status.within;
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
  if (answer.is_analysed)
    add_answer(answer, summary);
  if (answer.clamping)
    summary["clamping"] = json_of(*answer.clamping);
  if (!answer.provenance.is_null())
    summary[provenance_key] = answer.provenance;
  summary["timings"] = answer.timings;
  summary["versions"] = library_versions();
  return summary;
}

void write_summary_json(std::ostream &out,
                        const SpaceResults &answer,
                        const std::string &title,
                        const std::vector<CellDefect> &defects)
{
  Json summary = {{"title", title}};
  summary.update(summary_of(answer, defects));
  out << summary.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}
} // namespace Voussoir
