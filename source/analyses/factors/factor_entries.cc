// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/factors/factor_entries.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace Voussoir
{
void FactorEntries::add_parameters(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Load factor");
  add_choice<Factor>(
      prm, "Factor", multiplied,
      {{Factor::live_loads, "live loads",
        "the loads in 'Live loads'; those in 'Loads' stay as they are."},
       {Factor::all_loads, "all loads", "the loads in both sections."},
       {Factor::strength, "strength",
        "nothing: the strengths against sliding, s_T or c and mu, are divided "
        "by it, and the loads in both sections stay as they are."}},
      "What the factor multiplies.");
  add_choice<Direction>(
      prm, "Direction", direction,
      {{Direction::greatest, "greatest",
        "the greatest factor that is carried."},
       {Direction::least, "least",
        "the least one, which is negative where the loads may also act the "
        "other way."}},
      "Which end of the factors that are carried is looked for.");
  prm.leave_subsection();
}

LoadFactorControls FactorEntries::controls(const SolverControls &common) const
{
  return {direction == Direction::greatest, common.tolerance_of_factor,
          common.n_max_iterations, common.journal};
}

namespace
{
/** Up to which of the factors that were tried there are states. */
std::string states_that_end(const FactorTrials &trials)
{
  const double without = trials.without_state.front();
  const auto beyond =
      std::find_if(trials.with_state.begin(), trials.with_state.end(),
                   [without](const double factor) {
                     return std::abs(factor) > std::abs(without);
                   });
  return beyond == trials.with_state.begin()
             ? text("but ", text_to_copy(without), " has no state")
             : text("but states are known up to ",
                    text_to_copy(*std::prev(beyond)), " only, and ",
                    text_to_copy(without), " has none");
}

/** What the factors that were tried say of each other. */
template <typename SceneOf>
std::string description_without_dilatancy(const FactorOf<SceneOf> &factor)
{
  const auto smaller = [&](const double tried) {
    return std::abs(tried) < std::abs(factor.carried);
  };
  const FactorTrials &trials = factor.trials;
  const unsigned int n_with = std::count_if(trials.with_state.begin(),
                                            trials.with_state.end(), smaller);
  const unsigned int n_without = std::count_if(
      trials.without_state.begin(), trials.without_state.end(), smaller);
  std::string words = text_to_copy(factor.carried);
  if (factor.own_collapse)
    words += text(
        " is a collapse without dilatancy, by its own forces and mechanism, ",
        n_without > 0
            ? states_that_end(trials)
            : text("and the ", n_with, " smaller factors tried have states"));
  else if (n_without > 0)
    words +=
        text(" has a state without dilatancy, but of ", n_with + n_without,
             " smaller factors tried ", n_without,
             n_without > 1 ? " have none, the least of them " : " has none, ",
             text_to_copy(trials.without_state.front()));
  else
    words += text(
        " has a state without dilatancy, ",
        n_with > 1 ? text("and so have the ", n_with, " smaller factors tried")
        : n_with == 1 ? "and so has the one smaller factor tried"
                      : "the only factor tried that has one");
  words += "; of others nothing is known, since no theorem holds";
  return std::isfinite(factor.bound)
             ? text(words, "; ", text_to_copy(factor.bound),
                    " collapses, with it or without, which is proven")
             : words + "; no mechanism was found that bounds it";
}

/** A line for people on a factor between its proofs. */
template <typename SceneOf>
std::string words_of_proofs(const FactorOf<SceneOf> &factor)
{
  const std::string carried = text_to_copy(factor.carried);
  std::string words;
  if (factor.is_unbounded)
    words = carried + " is carried, and so is any beyond it: the live loads "
                      "balance by pressure alone";
  else if (!std::isfinite(factor.bound))
    words = carried + " is carried; no mechanism was found that bounds it";
  else
    words = text(carried, " is carried, ", text_to_copy(factor.bound),
                 " collapses; they differ by ", factor.width(), " of it");
  if (factor.collapses_without)
    words += "; the dead loads are not carried without the live ones";
  return words;
}

/** The same for summary.json, without words. */
template <typename SceneOf>
nlohmann::ordered_json json_of_proofs(const FactorOf<SceneOf> &factor)
{
  // The state that is written shows that any factor is carried, by one of them.
  nlohmann::ordered_json json = {
      {"carried", factor.is_unbounded ? factor.bound : factor.carried},
      {"bound", factor.bound},
      {"width", factor.width()},
      {"unbounded", factor.is_unbounded}};
  if (factor.is_unbounded)
    json["forces_at"] = factor.carried;
  if (std::isfinite(factor.bound) && !factor.is_unbounded)
    json["closing_violation"] = factor.proof.closing_violation;
  return json;
}

/** @param loads that the factor multiplies, in words. */
template <typename SceneOf>
std::string sentence_without_dilatancy(const FactorOf<SceneOf> &factor,
                                       const std::string &loads)
{
  std::ostringstream words;
  words.precision(4);
  words << "Without dilatancy " << factor.carried << " times " << loads
        << (factor.own_collapse ? " have a state that collapses by its own "
                                  "mechanism"
                                : " have a state");
  if (std::isfinite(factor.bound))
    words << ", and " << factor.bound
          << " times collapse with dilatancy or without";
  words << '.';
  return words.str();
}
} // namespace

template <typename SceneOf>
std::string description_of(const FactorOf<SceneOf> &factor)
{
  return factor.trials.empty() ? words_of_proofs(factor)
                               : description_without_dilatancy(factor);
}

template <typename SceneOf>
std::string sentence_of(const FactorOf<SceneOf> &factor,
                        const FactorEntries::Factor multiplied)
{
  using Factor = FactorEntries::Factor;
  const bool is_of_strength = multiplied == Factor::strength;
  const std::string loads =
      multiplied == Factor::all_loads ? "all loads" : "the live loads";
  if (!factor.trials.empty())
    return sentence_without_dilatancy(factor, loads);
  std::ostringstream words;
  words.precision(4);
  if (is_of_strength)
    words << "The loads are carried with all strengths divided by "
          << factor.carried;
  else
    words << factor.carried << " times " << loads << " are carried";
  if (factor.is_unbounded)
  {
    words << ", and so "
          << (is_of_strength ? "they are with any divisor beyond that."
                             : "is any factor beyond that: they balance by "
                               "pressure alone.");
    return words.str();
  }
  if (!std::isfinite(factor.bound))
  {
    words << "; no mechanism was found that bounds the factor.";
    if (factor.is_at_jump)
      words << " The weaker joints are, the greater are the forces that carry "
               "the loads.";
    return words.str();
  }
  words.precision(2);
  const bool is_least = !is_of_strength && factor.bound < factor.carried;
  words << (is_least ? " and no less" : " and no more") << ", proven within "
        << factor.width() << " of that";
  if (!is_least && factor.bound < 1. && multiplied != Factor::live_loads)
    words << (is_of_strength ? ": not with the strengths as they are"
                             : ": not the loads as they are");
  words << '.';
  if (factor.is_at_jump)
    words << " Between both divisors blocks begin to wedge, and the forces "
             "that carry the loads grow without limit or jump: nothing is "
             "proven there.";
  if (factor.collapses_without)
    words << " The dead loads are not carried without the live ones.";
  return words.str();
}

template <typename SceneOf>
nlohmann::ordered_json json_of(const FactorOf<SceneOf> &factor)
{
  nlohmann::ordered_json json = json_of_proofs(factor);
  if (factor.own_collapse)
    json["own_collapse"] = {
        {"factor", factor.own_collapse->factor},
        {"closing_violation", factor.own_collapse->closing_violation}};
  if (!factor.trials.empty())
    json["tried"] = {{"with_state", factor.trials.with_state},
                     {"without_state", factor.trials.without_state}};
  json["meaning"] = description_of(factor);
  return json;
}

template std::string description_of(const FactorOf<Scene> &);
template std::string description_of(const FactorOf<SpaceScene> &);
template std::string sentence_of(const FactorOf<Scene> &,
                                 FactorEntries::Factor);
template std::string sentence_of(const FactorOf<SpaceScene> &,
                                 FactorEntries::Factor);
template nlohmann::ordered_json json_of(const FactorOf<Scene> &);
template nlohmann::ordered_json json_of(const FactorOf<SpaceScene> &);
} // namespace Voussoir
