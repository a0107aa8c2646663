// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/factors/factor_entries.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>

#include <cmath>

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
          common.n_max_iterations};
}

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

template std::string words_of_proofs(const FactorOf<Scene> &);
template std::string words_of_proofs(const FactorOf<SpaceScene> &);
template nlohmann::ordered_json json_of_proofs(const FactorOf<Scene> &);
template nlohmann::ordered_json json_of_proofs(const FactorOf<SpaceScene> &);
} // namespace Voussoir
