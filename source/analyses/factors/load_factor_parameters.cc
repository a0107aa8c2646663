// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/factors/load_factor_parameters.h>
#include <voussoir/base/parameters/parameters.h>

namespace Voussoir
{
void LoadFactorParameters::add_parameters(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Load factor");
  add_choice<Factor>(
      prm, "Factor", chosen,
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
} // namespace Voussoir
