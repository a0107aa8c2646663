// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/range_analysis.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/formula/expression.h>
#include <voussoir/packing/cell_groups.h>
#include <voussoir/packing/group_names.h>

#include <deal.II/base/patterns.h>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

const std::string parameter_where = "Ranges/Where";
const std::string parameter_joints = "Ranges/Joints";

/** Choose the interfaces where the condition holds. */
void choose_where(const Packing<2> &packing,
                  const std::string &where,
                  const Condition &holds,
                  std::vector<bool> &chosen)
{
  bool any = false;
  for (unsigned int e = 0; e < chosen.size(); ++e)
  {
    const Packing<2>::Interface &i = packing.interfaces()[e];
    const dealii::Point<2> x = i.midpoint();
    chosen[e] = holds({x[0], x[1], i.normal[0], i.normal[1]});
    any |= chosen[e];
  }
  if (!any)
    throw InputError("The condition '" + where + "' of '" + parameter_where +
                     "' holds on no interface. It is asked at the midpoint x, "
                     "y of each, with its unit normal nx, ny; where rounding "
                     "matters write y < 1e-9 rather than y == 0.");
}

/** For each cell and the ground, whether it has the name. */
std::vector<bool> are_named(const Packing<2> &packing, const std::string &name)
{
  std::vector<bool> named(packing.n_cells() + 1, false);
  for (const unsigned int c : cells_of_name(packing, name, parameter_joints))
    named[c] = true;
  return named;
}

/** Choose the interfaces of one name, or between two. */
void choose_named(const Packing<2> &packing,
                  const std::string &names,
                  std::vector<bool> &chosen)
{
  const std::vector<std::string> words = split_names(names);
  if (words.size() > 2 || words.front().empty() || words.back().empty())
    throw InputError("The parameter '" + parameter_joints + "' has '" + names +
                     "' where one or two names are expected, as in \"keystone "
                     "| pier, ground\".");
  const std::vector<bool> one = are_named(packing, words.front());
  const std::vector<bool> other = words.size() == 2
                                      ? are_named(packing, words.back())
                                      : std::vector<bool>(one.size(), true);
  bool any = false;
  for (unsigned int e = 0; e < chosen.size(); ++e)
  {
    const unsigned int a = packing.interfaces()[e].cell_minus;
    const unsigned int b = packing.interfaces()[e].cell_plus;
    if (!((one[a] && other[b]) || (one[b] && other[a])))
      continue;
    chosen[e] = true;
    any = true;
  }
  if (!any)
    throw InputError("The parameter '" + parameter_joints + "' names '" +
                     names +
                     "', and there is no interface of that name; change it, "
                     "or leave it out.");
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

  unsigned int wanted = 0;     /**< that were asked for */
  unsigned int determined = 0; /**< with the same forces in all states */
  unsigned int unbounded = 0;  /**< with forces of any size */
};

/** The ranges of the reactions of all straight supports. */
Json summary_of_reactions(const Ranges &ranges)
{
  const auto pair = [](const Range &range) {
    return Json::array({range.least, range.greatest});
  };
  Json json = Json::array();
  for (unsigned int s = 0; s < ranges.reactions.size(); ++s)
  {
    const auto &[start, end, edges] = ranges.supports[s];
    const auto &[x, y] = ranges.reactions[s];
    json.push_back({{"from", {start[0], start[1]}},
                    {"to", {end[0], end[1]}},
                    {"x", pair(x)},
                    {"y", pair(y)}});
  }
  return json;
}

/** The ranges of forces, with the errors of their proofs over the loads. */
Json summary_of(const Ranges &ranges)
{
  const CountOfRanges count(ranges);
  return {{"interfaces", count.wanted},
          {"determined", count.determined},
          {"unbounded", count.unbounded},
          {"reactions", summary_of_reactions(ranges)},
          {"width", ranges.reference > 0.
                        ? Json(ranges.proofs.width / ranges.reference)
                        : Json(nullptr)},
          {"error_of_states", ranges.proofs.error_of_states},
          {"closing_violation", ranges.proofs.closing_violation},
          {"programmes", ranges.proofs.n_programmes},
          {"iterations", ranges.proofs.n_iterations}};
}
} // namespace

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

void RangeAnalysis::add_parameters(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Ranges");
  prm.add_parameter(
      "Where", where,
      "The interfaces of which the least and the greatest normal and "
      "tangential force are found, over all admissible states that carry the "
      "loads: those at whose midpoint x, y, with the unit normal nx, ny, this "
      "expression is not zero. Each takes four linear programmes, from "
      "thousandths of a second each with hundreds of cells to seconds with "
      "tens of thousands. 1: all. 0: none.",
      dealii::Patterns::Anything());
  prm.add_parameter(
      "Joints", joints,
      "Interfaces by name, besides: of the cells of a group, or of a cell with "
      "a number, with all that touch them, as in keystone or cell 12; or "
      "between two of these, as in brick, lintel or cell 3, cell 4 or pier, "
      "ground. Several are separated by bars: keystone | pier, ground.",
      dealii::Patterns::Anything());
  prm.add_parameter(
      "Reactions", reactions,
      "true: also find the least and the greatest reaction of each straight "
      "support, in x (the thrust, if x is horizontal) and in y.",
      dealii::Patterns::Bool());
  add_choice<RangeMethod>(
      prm, "Method", method,
      {{RangeMethod::automatic, "automatic",
        "the one that is likely to be the quicker."},
       {RangeMethod::simplex, "simplex",
        "the simplex method, which goes from the end of one range to that of "
        "the next: for many forces."},
       {RangeMethod::interior_point, "interior point",
        "an interior point, which takes about as long as a load factor for "
        "each end: for few forces of large packings. Reactions of supports of "
        "several interfaces are left to the simplex method."}},
      "How they are found.");
  prm.leave_subsection();
}

std::optional<RangesWanted>
RangeAnalysis::wanted(const Packing<2> &packing) const
{
  const Condition holds(where, {"x", "y", "nx", "ny"}, parameter_where);
  RangesWanted wanted = {std::vector<bool>(packing.interfaces().size(), false),
                         reactions, method};
  if (reactions && packing.n_supports() == 0)
    throw InputError("'Ranges/Reactions' is true, and there are no supports: "
                     "'Supports/Where' gives them.");
  if (!holds.is_never())
    choose_where(packing, where, holds, wanted.interfaces);
  if (!joints.empty())
    for (const std::string &names : split_at_bars(joints))
      choose_named(packing, names, wanted.interfaces);
  if (holds.is_never() && joints.empty() && !reactions)
    return {};
  return wanted;
}

void RangeAnalysis::check(const Scene &scene) const
{
  wanted(scene.packing);
}

void RangeAnalysis::answer(AnalysisOutcome &outcome,
                           const AnalysisContext &context) const
{
  const Scene &scene = *outcome.scene;
  const std::optional<RangesWanted> of = wanted(scene.packing);
  if (!of)
    return;
  const dealii::TimerOutput::Scope section(context.timer, name());
  context.terminal.begin("Ranges");
  Ranges found = find_ranges(scene, *of, context.terminal);
  context.terminal.stage(
      "Ranges", text(counted(found.proofs.n_programmes, "linear programme"),
                     ", ", counted(found.proofs.n_iterations, "step")));
  AnalysisResult result = {name(), "Ranges", description_of(found),
                           summary_of(found)};
  result.data = std::move(found);
  outcome.results.push_back(std::move(result));
}
} // namespace Voussoir
