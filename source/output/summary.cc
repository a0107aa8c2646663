// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/messages.h>
#include <voussoir/output/summary.h>
#include <voussoir/packing/connected_groups.h>
#include <voussoir/scene/jumps.h>
#include <voussoir/version.h>

#include <deal.II/base/config.h>

#include <CGAL/version.h>
#include <IpoptConfig.h>
#include <boost/version.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cholmod.h>
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
constexpr unsigned int n_shown_supports = 4;

/** The beginning of every summary. */
Json summary_of(const RunRecord &run, const Status &status)
{
  const Packing &packing = run.scene.packing;
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
    summary["friction_law"] =
        run.scene.dilates ? "associated Coulomb" : "Coulomb";
  summary["formulation"] = run.formulation;
  summary["selection"] = run.selection;
  summary["packing"] = {
      {"cells", packing.n_cells()},
      {"interfaces", packing.interfaces().size()},
      {"supports", packing.n_supports()},
      {"boundary_edges", packing.boundary_edges().size()},
      {"static_indeterminacy",
       static_indeterminacy(packing, run.scene.kinematics->n_unknowns())},
      {"groups", groups}};
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

/** The loads, and what the ground does about them. */
Json ground_summary(const Results &results)
{
  const auto pair = [](const auto &v) { return Json::array({v[0], v[1]}); };
  Json supports = Json::array();
  for (const Reaction &reaction : results.reactions)
    supports.push_back({{"from", pair(reaction.start)},
                        {"to", pair(reaction.end)},
                        {"reaction", pair(reaction.force)}});
  const GroundBalance balance =
      balance_on_ground(results.scene, results.reactions);
  return {{"load", pair(balance.load)},
          {"reaction", pair(balance.reaction)},
          {"imbalance", balance.imbalance},
          {"supports", supports}};
}

/** The number, or null, which stands for what is not finite. */
Json finite(const double x)
{
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

/** The load factor between its proofs. */
Json summary_of_factor(const LoadFactor &factor)
{
  Json json = {{"carried", factor.carried},
               {"bound", finite(factor.bound)},
               {"width", finite(factor.width())},
               {"unbounded", factor.is_unbounded}};
  if (factor.has_mechanism())
    json["closing_violation"] = factor.proof.closing_violation;
  return json;
}

/** How many interfaces have their ranges, and of which kinds they are. */
struct CountOfRanges
{
  explicit CountOfRanges(const Ranges &ranges)
  {
    for (unsigned int e = 0; e < ranges.wanted.size(); ++e)
    {
      wanted += ranges.wanted[e];
      determined += ranges.is_determined(e);
      unbounded += ranges.is_unbounded(e);
    }
  }

  unsigned int wanted = 0, determined = 0, unbounded = 0;
};

/** The ranges of forces, with the errors of their proofs over the loads. */
Json summary_of_ranges(const Results &results)
{
  const Ranges &ranges = *results.ranges;
  const CountOfRanges count(ranges);
  const auto pair = [](const Range &range) {
    return Json::array({finite(range.least), finite(range.greatest)});
  };
  Json supports = Json::array();
  for (unsigned int s = 0; s < ranges.reactions.size(); ++s)
  {
    const Reaction &at = results.reactions[s];
    supports.push_back({{"from", {at.start[0], at.start[1]}},
                        {"to", {at.end[0], at.end[1]}},
                        {"x", pair(ranges.reactions[s][0])},
                        {"y", pair(ranges.reactions[s][1])}});
  }
  return {{"interfaces", count.wanted},
          {"determined", count.determined},
          {"unbounded", count.unbounded},
          {"reactions", supports},
          {"width", ranges.reference > 0.
                        ? Json(ranges.proofs.width / ranges.reference)
                        : Json(nullptr)},
          {"error_of_states", ranges.proofs.error_of_states},
          {"closing_violation", ranges.proofs.closing_violation},
          {"programmes", ranges.proofs.n_programmes},
          {"iterations", ranges.proofs.n_iterations}};
}

std::string description_of(const Ranges &ranges)
{
  const CountOfRanges count(ranges);
  std::string words = text("forces of ", counted(count.wanted, "interface"),
                           ": ", count.determined, " determined by statics");
  if (count.unbounded > 0)
    words += text(", ", count.unbounded, " without bound");
  if (!ranges.reactions.empty())
    words += text("; reactions of ",
                  counted(ranges.reactions.size(), "straight support"));
  return words;
}

/** A jump, over the largest displacement of a support, that is one. */
constexpr double least_jump = 1e-6;

/** How many interfaces a settlement opens or lets slide. */
struct CountOfJumps
{
  CountOfJumps(const Scene &scene, const Settlement &settlement)
  {
    const InterfaceJumps jumps = jumps_of(scene.packing, settlement.motion);
    const double least = least_jump * settlement.largest_displacement;
    for (unsigned int e = 0; e < jumps.sliding.size(); ++e)
    {
      const bool at_start = jumps.openings[e][0] > least;
      const bool at_end = jumps.openings[e][1] > least;
      open += at_start && at_end;
      hinges += at_start != at_end;
      sliding += std::abs(jumps.sliding[e]) > least;
    }
  }

  /** Along all of them; at one end only; and that slide. */
  unsigned int open = 0, hinges = 0, sliding = 0;
};

Json summary_of_settlement(const Results &results)
{
  const Settlement &settlement = *results.settlement;
  const CountOfJumps count(results.scene, settlement);
  return {{"largest_displacement", settlement.largest_displacement},
          {"work", settlement.work},
          {"width", settlement.width},
          {"closing_violation", settlement.closing_violation},
          {"hinges", count.hinges},
          {"open", count.open},
          {"sliding", count.sliding}};
}

std::string description_of(const Scene &scene, const Settlement &settlement)
{
  const CountOfJumps count(scene, settlement);
  return text("supports move by at most ", settlement.largest_displacement,
              "; interfaces with a hinge: ", count.hinges,
              ", open: ", count.open, ", sliding: ", count.sliding);
}

/** Add what stands last, and write. */
void write(std::ostream &out, Json summary, const RunRecord &run)
{
  summary["timings"] = run.timings;
  summary["versions"] = {
      {"voussoir", VOUSSOIR_VERSION},
      {"deal.II", DEAL_II_PACKAGE_VERSION},
      {"Ipopt", IPOPT_VERSION},
      {"CHOLMOD", text(CHOLMOD_MAIN_VERSION, ".", CHOLMOD_SUB_VERSION, ".",
                       CHOLMOD_SUBSUB_VERSION)},
      {"CGAL", CGAL_VERSION_STR},
      {"Boost", text(BOOST_VERSION / 100000, ".", BOOST_VERSION / 100 % 1000,
                     ".", BOOST_VERSION % 100)},
      {"Trilinos",
       text(DEAL_II_TRILINOS_VERSION_MAJOR, ".", DEAL_II_TRILINOS_VERSION_MINOR,
            ".", DEAL_II_TRILINOS_VERSION_SUBMINOR)}};
  out << summary.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

/** The law of friction, and what it means for what is carried. */
std::string description_of_law(const Scene &scene)
{
  return scene.dilates
             ? "Coulomb, associated: joints that slide open, too"
             : "Coulomb, without dilatancy: this state carries the loads, but "
               "no theorem says that the blocks stay in it";
}

std::string description_of(const LoadFactor &factor)
{
  if (factor.passes.n > 0)
    return text(text_to_copy(factor.carried),
                " has a state without dilatancy; ", text_to_copy(factor.bound),
                " collapses, with it or without");
  if (factor.is_unbounded)
    return text(text_to_copy(factor.carried),
                " is carried, and so is any beyond it: the live loads balance "
                "by pressure alone");
  if (!std::isfinite(factor.bound))
    return text_to_copy(factor.carried) +
           " is carried; no mechanism was found that bounds it";
  return text(text_to_copy(factor.carried), " is carried, ",
              text_to_copy(factor.bound), " collapses; they differ by ",
              factor.width(), " of it");
}
} // namespace

void write_summary_json(std::ostream &out, const Results &results)
{
  const Certificate &certificate = results.certificate;
  Json summary = summary_of(results, results.status);
  if (results.correction)
    summary["solver"]["correction"] = *results.correction;
  summary["certificate"] = {
      {"equilibrium_residual", certificate.equilibrium_residual},
      {"admissibility_violation", certificate.admissibility_violation},
      {"max_utilisation", certificate.max_utilisation},
      {"max_torque", certificate.max_torque}};
  if (results.scene.turns())
    summary["certificate"]["moment_residual"] = certificate.moment_residual;
  if (!certificate.unbalanced.empty() &&
      results.status.kind != Status::Kind::solved)
    summary["certificate"]["unbalanced_cells"] = certificate.unbalanced.size();
  if (results.load_factor)
    summary["load_factor"] = summary_of_factor(*results.load_factor);
  if (results.settlement)
    summary["settlement"] = summary_of_settlement(results);
  if (results.ranges)
    summary["ranges"] = summary_of_ranges(results);
  if (results.samples)
    summary["samples"] = {
        {"number", results.samples->n},
        {"steps", results.samples->n_steps},
        {"dimension", results.samples->dimension},
        {"mixing", results.samples->mixing},
        {"error_of_states", results.samples->error_of_states}};
  if (!results.reactions.empty())
    summary["ground"] = ground_summary(results);
  if (!results.never_pressed.empty())
    summary["interfaces"] = {
        {"never_pressed", std::count(results.never_pressed.begin(),
                                     results.never_pressed.end(), true)},
        {"always_sliding", std::count(results.always_sliding.begin(),
                                      results.always_sliding.end(), true)}};
  summary["stress"] = {{"sub_cells", results.stress.n_sub_cells},
                       {"undetermined_cells", results.stress.undetermined}};
  write(out, std::move(summary), results);
}

void write_summary_json(std::ostream &out, const Collapse &collapse)
{
  Json summary = summary_of(collapse, {Status::Kind::collapse, 0.});
  Json parts = Json::array();
  for (const LoadPart &part : collapse.parts)
    parts.push_back({{"load", part.name}, {"work", part.work}});
  // JSON has no infinity: null stands for work that friction does not resist.
  summary["mechanism"] = {
      {"work_over_dissipation", collapse.proof.work_over_dissipation},
      {"closing_violation", collapse.proof.closing_violation},
      {"work_of_loads", parts}};
  write(out, std::move(summary), collapse);
}

void show_packing(Terminal &terminal, const Packing &packing)
{
  terminal.stage(
      "Packing",
      text(counted(packing.n_cells(), "cell"), ", ",
           counted(packing.interfaces().size(), "interface"), ", ",
           packing.n_supports(), " of them supports, ",
           counted(packing.boundary_edges().size(), "boundary edge")));
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
  if (results.load_factor)
    terminal.summary("Load factor", description_of(*results.load_factor));
  terminal.summary("Selection", results.selection);
  if (results.settlement)
    terminal.summary("Settlement",
                     description_of(results.scene, *results.settlement));
  if (results.ranges)
    terminal.summary("Ranges", description_of(*results.ranges));
  if (results.samples)
    terminal.summary("Samples",
                     text(results.samples->n, " of all states, a set of ",
                          counted(results.samples->dimension, "dimension"),
                          "; mixing ", results.samples->mixing));
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
  if (!results.reactions.empty())
  {
    const GroundBalance balance =
        balance_on_ground(results.scene, results.reactions);
    terminal.summary(
        "Reaction",
        text("(", balance.reaction[0], ", ", balance.reaction[1], ") on ",
             counted(results.reactions.size(), "straight support")));
  }
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
}
} // namespace Voussoir
