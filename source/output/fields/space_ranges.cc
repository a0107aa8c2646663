// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/space_ranges.h>

#include <limits>
#include <string>
#include <vector>

namespace Voussoir
{
namespace
{
/** No value of interfaces whose ranges are not asked for. */
constexpr double not_among_those = std::numeric_limits<double>::quiet_NaN();

/** The force on c- of an interface along n_e, and across it. */
dealii::Tensor<1, 3> force_on_face(const SpaceResults &a, const unsigned int e)
{
  return a.forces.resultant(a.scene.packing(), e).force;
}

/** One end of the range of the normal force. */
Field<SpaceResults> end_of_normal(const std::string &name,
                                  double Range::*const end)
{
  return Field<SpaceResults>(
             name, "S L^2",
             "the least and the greatest normal force over [all admissible "
             "states](theory.md#ranges-of-forces), inf without bound; empty "
             "where not asked for",
             [end](const SpaceResults &a, const unsigned int e) {
               return a.ranges->wanted[e] ? a.ranges->normal[e].*end
                                          : not_among_those;
             })
      .instead_in_grid(
          [](const SpaceResults &a, const unsigned int e) {
            return force_on_face(a, e) *
                   a.scene.packing().interfaces()[e].normal;
          },
          "where there is no bound, or none is asked for, the value of this "
          "state");
}

/** One end of the ranges of the components of the shear force. */
Field<SpaceResults> end_of_shear(const std::string &name,
                                 double Range::*const end)
{
  return Field<SpaceResults>(
             name, "S L^2",
             "the same of each component of the shear force, each by itself",
             [end](const SpaceResults &a, const unsigned int e) {
               dealii::Tensor<1, 3> ends;
               for (unsigned int i = 0; i < 3; ++i)
                 ends[i] = a.ranges->wanted[e] ? a.ranges->shear[e][i].*end
                                               : not_among_those;
               return ends;
             })
      .with_columns({name + "_x", name + "_y", name + "_z"})
      .only_in_table();
}
} // namespace

Fields<SpaceResults> face_ranges()
{
  return when<SpaceResults>(
      {"with `Ranges`",
       [](const SpaceResults &a) { return a.ranges.has_value(); }},
      {end_of_normal("normal_force_min", &Range::least),
       end_of_normal("normal_force_max", &Range::greatest),
       end_of_shear("shear_force_min", &Range::least),
       end_of_shear("shear_force_max", &Range::greatest),
       Field<SpaceResults>(
           "determined", "",
           "1 where all ranges vanish, so that all states have this force",
           [](const SpaceResults &a, const unsigned int e) {
             return a.ranges->wanted[e] ? double(a.ranges->is_determined(e))
                                        : not_among_those;
           })
           .as_integer()
           .instead_in_grid(
               [](const SpaceResults &, unsigned int) { return -1.; },
               "-1 where none is asked for")});
}
} // namespace Voussoir
