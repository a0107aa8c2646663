// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/summary/ground_summary.h>
#include <voussoir/output/summary/kernel_summary.h>
#include <voussoir/output/summary/link_summary.h>
#include <voussoir/output/summary/messages.h>
#include <voussoir/output/summary/provenance.h>
#include <voussoir/output/summary/scene_summary.h>
#include <voussoir/output/summary/summary.h>
#include <voussoir/output/summary/versions.h>
#include <voussoir/packing/connected_groups.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <utility>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

/** The largest number of supports that are named on the terminal. */
constexpr unsigned int n_shown_supports = 8;

/** The beginning of every summary. */
Json summary_of(const RunRecord &run, const Status &status)
{
  const Packing<2> &packing = run.scene.packing;
  std::vector<unsigned int> group_sizes(packing.group_names().size(), 0);
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    ++group_sizes[packing.group(c)];
  Json groups = Json::array();
  for (unsigned int g = 0; g + 1 < group_sizes.size(); ++g)
    groups.push_back(
        {{"name", packing.group_names()[g]}, {"cells", group_sizes[g]}});

  Json summary;
  summary["title"] = run.title;
  summary["status"] = status.word();
  if (status.kind == Status::Kind::carried_within)
    summary["within"] = status.within;
  summary["processes"] = run.n_processes;
  if (run.scene.turns())
    summary["rotations"] = true;
  if (!run.scene.coefficient.empty())
    summary["friction_law"] = run.scene.friction_law;
  summary["formulation"] = run.formulation;
  summary["selection"] = run.selection;
  const dealii::BoundingBox<2> box = packing.box();
  summary["packing"] = {
      {"cells", packing.n_cells()},
      {"interfaces", packing.interfaces().size()},
      {"supports", packing.n_supports()},
      {"boundary_edges", packing.boundary_edges().size()},
      {"extent", {box.side_length(0), box.side_length(1)}},
      {"area", packing.area()},
      {"static_indeterminacy",
       static_indeterminacy(packing, run.scene.group,
                            run.scene.kinematics->n_unknowns(),
                            run.scene.links.size())},
      {"groups", groups}};
  summary["loads"] = loads_summary(run.scene);
  summary["solver"] = {{"outcome", run.outcome},
                       {"iterations", run.n_iterations},
                       {"evaluations", run.n_evaluations}};
  if (run.passes.n > 0)
    summary["solver"]["passes"] = {{"number", run.passes.n},
                                   {"rate", run.passes.rate}};
  if (!run.solver_seconds.empty())
    summary["solver"]["seconds"] = run.solver_seconds;
  if (!run.earlier_outcome.empty())
    summary["solver"]["earlier_outcome"] = run.earlier_outcome;
  return summary;
}

/** Show the line of what answers `Analysis` itself, or those of all others. */
void show_analyses(Terminal &terminal,
                   const Results &results,
                   const bool verdict)
{
  for (const AnalysisResult &analysis : results.analyses)
    if (analysis.is_verdict == verdict)
      terminal.summary(analysis.title, analysis.description);
}

/** Add what stands last. */
Json complete(Json summary, const RunRecord &run)
{
  if (!run.provenance.is_null())
    summary[provenance_key] = run.provenance;
  summary["timings"] = run.timings;
  summary["versions"] = library_versions();
  return summary;
}

/** Write it; null stands for what is not finite, which JSON has no word for. */
void write(std::ostream &out, const Json &summary)
{
  out << summary.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

} // namespace

Json summary_of(const Results &results)
{
  const Certificate &certificate = results.certificate;
  Json summary = summary_of(results, results.status);
  if (results.correction)
    summary["solver"]["correction"] = *results.correction;
  summary["certificate"] = {
      {"equilibrium_residual", certificate.equilibrium_residual},
      {"admissibility_violation", certificate.admissibility_violation},
      {"max_utilisation", certificate.max_utilisation},
      {"max_torque", certificate.max_torque},
      {"load_residual", certificate.load_residual}};
  if (results.scene.turns())
    summary["certificate"]["moment_residual"] = certificate.moment_residual;
  if (!certificate.unbalanced.empty() &&
      results.status.kind != Status::Kind::solved)
    summary["certificate"]["unbalanced_cells"] = certificate.unbalanced.size();
  for (const AnalysisResult &analysis : results.analyses)
    summary[analysis.key] = analysis.summary;
  if (!results.reactions.empty())
    summary["ground"] = ground_summary(results);
  if (!results.scene.links.empty())
    summary["links"] = links_summary(results);
  summary["most_used"] = most_used_summary(results);
  if (!results.never_pressed.empty())
    summary["interfaces"] = {
        {"never_pressed", std::count(results.never_pressed.begin(),
                                     results.never_pressed.end(), true)},
        {"always_sliding", std::count(results.always_sliding.begin(),
                                      results.always_sliding.end(), true)}};
  summary["stress"] = {{"sub_cells", results.stress.n_sub_cells},
                       {"undetermined_cells", results.stress.undetermined}};
  return complete(std::move(summary), results);
}

/** Which loads are not carried. */
std::string loads_of(const Collapse &collapse)
{
  using Loads = NotCarried::Loads;
  return collapse.loads == Loads::all    ? "all"
         : collapse.loads == Loads::dead ? "dead"
                                         : "dead, with any factor";
}

Json summary_of(const Collapse &collapse)
{
  Json summary = summary_of(collapse, {Status::Kind::collapse, 0.});
  Json parts = Json::array();
  for (const LoadPart &part : collapse.parts)
    parts.push_back({{"load", part.name}, {"work", part.work}});
  summary["mechanism"] = {
      {"loads", loads_of(collapse)},
      {"work_over_dissipation", collapse.proof.work_over_dissipation},
      {"closing_violation", collapse.proof.closing_violation},
      {"load_residual", collapse.proof.load_residual},
      {"work_of_loads", parts}};
  return complete(std::move(summary), collapse);
}

void write_summary_json(std::ostream &out, const Results &results)
{
  write(out, summary_of(results));
}

void write_summary_json(std::ostream &out, const Collapse &collapse)
{
  write(out, summary_of(collapse));
}

void show_packing(Terminal &terminal, const Packing<2> &packing)
{
  const dealii::BoundingBox<2> box = packing.box();
  terminal.stage("Packing",
                 text(counted(packing.n_cells(), "cell"), ", ",
                      counted(packing.interfaces().size(), "interface"), ", ",
                      packing.n_supports(), " of them supports, ",
                      counted(packing.boundary_edges().size(), "boundary edge"),
                      ", on ", box.side_length(0), " x ", box.side_length(1)));
  show_faster_kernel(terminal, packing.n_cells());
  for (const std::string &warning : cells_not_convex(packing))
    terminal.warning(warning);
  const std::vector<StraightRun> supports = straight_supports(packing);
  for (unsigned int k = 0; k < supports.size() && k < n_shown_supports; ++k)
    terminal.stage("Support", "from " + text_of_point(supports[k].start) +
                                  " to " + text_of_point(supports[k].end));
  if (supports.size() > n_shown_supports)
    terminal.stage("Support",
                   text("and ", supports.size() - n_shown_supports, " more"));
}

void show_summary(Terminal &terminal, const Results &results)
{
  const Certificate &certificate = results.certificate;
  double most_compressed = 0.;
  const auto &interfaces = results.scene.packing.interfaces();
  for (unsigned int e = 0; e < interfaces.size(); ++e)
    most_compressed = std::min(most_compressed,
                               results.forces.normal[e] / interfaces[e].length);

  terminal.status(results.status.description(), true);
  show_analyses(terminal, results, true);
  terminal.summary("Selection", results.selection);
  show_analyses(terminal, results, false);
  if (!results.scene.coefficient.empty())
    terminal.summary("Law", description_of_law(results.scene));
  if (!results.earlier_outcome.empty())
    terminal.summary("Forces", results.outcome);
  if (results.correction)
    terminal.summary("Equilibrated", text("by at most ", *results.correction,
                                          " of the largest force"));
  terminal.summary("Equilibrium",
                   text("residual ", certificate.equilibrium_residual,
                        " of the largest load on a cell"));
  terminal.summary("Admissibility",
                   text("violation ", certificate.admissibility_violation,
                        " of the largest load on a cell"));
  show_reactions(terminal, results);
  show_link_forces(terminal, results);
  terminal.summary("Friction",
                   text("largest utilisation ", certificate.max_utilisation));
  terminal.summary("Contact",
                   text("largest compressive stress on an interface ",
                        std::abs(most_compressed)));
  terminal.summary("Torque",
                   text("largest residual ", certificate.max_torque,
                        " of load times cell size",
                        results.scene.turns() || results.overturning ||
                                certificate.max_torque <= largest_accepted_error
                            ? ""
                            : ", which couples of the interfaces can balance"));
  show_most_used(terminal, results);
}
} // namespace Voussoir
