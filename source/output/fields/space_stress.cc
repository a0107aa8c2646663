// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/space_stress.h>

#include <string>

namespace Voussoir
{
namespace
{
/** The mean stress of a cell; that of a fixed one is none. */
dealii::Tensor<2, 3> mean_stress_of(const SpaceResults &r, const unsigned int c)
{
  return c < r.mean_stresses.size() ? r.mean_stresses[c]
                                    : dealii::Tensor<2, 3>();
}

/** A principal stress anywhere in a cell. */
Field<SpaceResults> extreme(const std::string &name,
                            const std::string &words,
                            double PrincipalStresses::*const of)
{
  return Field<SpaceResults>(
      name, "S", words, [of](const SpaceResults &r, const unsigned int c) {
        return c < r.principal.size() ? r.principal[c].*of : 0.;
      });
}
} // namespace

Fields<SpaceResults> polyhedron_stress()
{
  return together<SpaceResults>(
      {when<SpaceResults>(
           {"with loads that are carried",
            [](const SpaceResults &r) { return !r.mean_stresses.empty(); }},
           {Field<SpaceResults>(
                "mean_stress", "S",
                "the mean stress, from the forces alone; component ij is "
                "sigma_ij, tension positive",
                mean_stress_of)
                .with_columns({"sxx", "sxy", "sxz", "syx", "syy", "syz", "szx",
                               "szy", "szz"}),
            extreme("principal_stress_min",
                    "the least principal stress anywhere in the cell; with "
                    "`Accuracy = draft` that of the mean stress",
                    &PrincipalStresses::least),
            extreme("principal_stress_max", "the greatest one",
                    &PrincipalStresses::greatest)}),
       when<SpaceResults>(
           {"with loads that are carried and `Accuracy = fine`",
            [](const SpaceResults &r) { return !r.stresses.empty(); }},
           {Field<SpaceResults>(
               "stress_residual", "",
               "by how much the forces on the faces differ from those of the "
               "linear stress, in the mean over the faces",
               [](const SpaceResults &r, const unsigned int c) {
                 return c < r.stresses.size() ? r.stresses[c].residual : 0.;
               })})});
}
} // namespace Voussoir
