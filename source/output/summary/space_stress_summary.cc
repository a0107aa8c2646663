// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/summary/space_stress_summary.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

/** A principal stress and the cell that has it. */
struct ExtremeStress
{
  double value = 0.;
  unsigned int cell = 0;
};

/** The extremes of all cells, and how well tractions are met. */
struct StressExtremes
{
  explicit StressExtremes(const SpaceResults &results)
  {
    for (unsigned int c = 0; c < results.principal.size(); ++c)
    {
      const PrincipalStresses &of = results.principal[c];
      if (c == 0 || of.least < least.value)
        least = {of.least, c};
      if (c == 0 || of.greatest > greatest.value)
        greatest = {of.greatest, c};
    }
    for (const LinearStress &of : results.stresses)
    {
      largest_residual = std::max(largest_residual, of.residual);
      mean_residual += of.residual * of.residual / results.stresses.size();
    }
    mean_residual = std::sqrt(mean_residual);
  }
  ExtremeStress least, greatest;
  double largest_residual = 0., mean_residual = 0.;
};

Json json_of(const ExtremeStress &of)
{
  return {{"value", of.value}, {"cell", of.cell}};
}
} // namespace

Json json_of_stress(const SpaceResults &results)
{
  const StressExtremes of(results);
  Json json = {{"accuracy", results.tetrahedra         ? "standard"
                            : results.stresses.empty() ? "draft"
                                                       : "fine"},
               {"principal_stress_min", json_of(of.least)},
               {"principal_stress_max", json_of(of.greatest)}};
  if (results.tetrahedra)
    json["undetermined"] = results.tetrahedra->undetermined;
  if (!results.stresses.empty())
    json["residual"] = {{"largest", of.largest_residual},
                        {"root_mean_square", of.mean_residual}};
  return json;
}

namespace
{
/** Of what the stress is, behind its extremes. */
std::string what_stress(const SpaceResults &results, const StressExtremes &of)
{
  if (results.tetrahedra)
  {
    const std::size_t n_without = results.tetrahedra->undetermined.size();
    return text(", in ", results.tetrahedra->list.size(), " tetrahedra",
                n_without == 0
                    ? std::string()
                    : text("; ", counted(n_without, "block"),
                           " not seen whole from the centroid, or with open "
                           "faces, with the mean stress instead"));
  }
  if (results.stresses.empty())
    return ", of the means of blocks";
  return text(", linear in each block; tractions are met to ", of.mean_residual,
              " of them in the mean");
}
} // namespace

void show_stress(Terminal &terminal, const SpaceResults &results)
{
  const StressExtremes of(results);
  terminal.stage("Stress",
                 text("principal stresses from ", of.least.value, " in cell ",
                      of.least.cell, " to ", of.greatest.value, " in cell ",
                      of.greatest.cell, what_stress(results, of)));
}
} // namespace Voussoir
