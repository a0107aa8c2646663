// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/strengths.h>
#include <voussoir/scene/proofs/utilisation.h>

namespace Voussoir
{
namespace
{
/** A limit in tables, if the scene has it. @param words when. */
Fields<Scene> limit_when(const std::string &words,
                         std::vector<double> Scene::*const limits,
                         Field<Scene> field)
{
  return when<Scene>(
      {words, [limits](const Scene &s) { return !(s.*limits).empty(); }},
      {field.only_in_table()});
}
} // namespace

Fields<Scene> strengths()
{
  return {{"strength", "S", "s_e",
           [](const Scene &s) { return Stored(s.strength); }}};
}

Fields<Results> utilisations()
{
  return {{"utilisation", "",
           "|f_e^t| / (s_e |e|); 0 where f_e^t is below 1e-12 of the largest "
           "force, which is rounding",
           [](const Results &r) { return Utilisation(r.scene, r.forces); }}};
}

Fields<Scene> further_limits()
{
  return together<Scene>(
      {limit_when("with Coulomb's friction", &Scene::coefficient,
                  {"coefficient", "",
                   "mu_e; then strength is c_e, and utilisation over c_e |e| - "
                   "mu_e f_e^n",
                   [](const Scene &s) { return Stored(s.coefficient); }}),
       limit_when("where joints bear tension", &Scene::tensile_strength,
                  {"tensile_strength", "S", "f_t",
                   [](const Scene &s) { return Stored(s.tensile_strength); }}),
       limit_when(
           "where joints crush", &Scene::compressive_strength,
           {"compressive_strength", "S", "f_c, inf where an interface does not",
            [](const Scene &s) { return Stored(s.compressive_strength); }})});
}

Fields<Results> crushing_utilisations()
{
  return only_in_table(when<Results>(
      {"where joints crush",
       [](const Results &r) { return !r.scene.compressive_strength.empty(); }},
      {{"crushing_utilisation", "",
        "|f_e^n| over the most that its "
        "[section](theory.md#tension-and-crushing) bears at this eccentricity, "
        "pressed or, beside a tensile strength, pulled: at 1 it crushes or "
        "tears, as it would with this share of both strengths",
        [](const Results &r, const unsigned int e) {
          return r.scene.limits(e).crushing_utilisation(r.forces.ends(e));
        }}}));
}
} // namespace Voussoir
