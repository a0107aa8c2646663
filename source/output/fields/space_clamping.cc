// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/space_clamping.h>

#include <string>
#include <vector>

namespace Voussoir
{
namespace
{
using dealii::Tensor;

/** A vector of a cell in the motion; zero of those that do not move. */
template <typename Of>
Field<SpaceResults> of_opening(const std::string &name,
                               const std::string &unit,
                               const std::string &words,
                               const Of &list)
{
  return Field<SpaceResults>(
             name, unit, words,
             [list](const SpaceResults &a, const unsigned int c) {
               const std::vector<Tensor<1, 3>> &of = list(a.clamping->opening);
               return c < of.size() ? of[c] : Tensor<1, 3>();
             })
      .with_columns({name + "_x", name + "_y", name + "_z"});
}
} // namespace

Fields<SpaceResults> face_self_stress()
{
  return when<SpaceResults>(
      {"with `Clamping`, of what is clamped",
       [](const SpaceResults &a) {
         return a.clamping && a.clamping->is_clamped();
       }},
      {Field<SpaceResults>(
          "self_stress", "",
          "the normal force on c- in a [state without "
          "loads](theory.md#clamped-packings), negative in compression; the "
          "largest has the size 1",
          [](const SpaceResults &a, const unsigned int e) {
            const Packing<3> &packing = a.scene.packing();
            return a.clamping->self_stress.resultant(packing, e).force *
                   packing.interfaces()[e].normal;
          })});
}

Fields<SpaceResults> opening_motion()
{
  return when<SpaceResults>(
      {"with `Clamping`, of what is not clamped",
       [](const SpaceResults &a) { return a.clamping && a.clamping->opens(); }},
      {of_opening(
           "opening_displacement", "L",
           "of its centre in a motion that opens every interface, of "
           "any size",
           [](const SpaceMotion &motion) -> const auto & {
             return motion.displacement;
           }),
       of_opening(
           "opening_rotation", "",
           "its angle in that; zero where blocks do not turn",
           [](const SpaceMotion &motion) -> const auto & {
             return motion.rotation;
           })});
}
} // namespace Voussoir
