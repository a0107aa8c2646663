// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/factors/divided_strengths.h>
#include <voussoir/base/exceptions.h>

#include <memory>
#include <utility>

namespace Voussoir
{
namespace
{
/** @{ */
/** Whether blocks that slide lift off as friction has it. */
bool dilates(const Scene &scene)
{
  return scene.dilates;
}
bool dilates(const SpaceScene &scene)
{
  return scene.blocks->strengths.dilate;
}
/** @} */
} // namespace

Scene with_strengths_divided(const Scene &scene, const double divisor)
{
  Scene divided = scene;
  for (auto *const strengths : {&divided.strength, &divided.coefficient})
    for (double &strength : *strengths)
      strength /= divisor;
  return divided;
}

SpaceScene with_strengths_divided(const SpaceScene &scene, const double divisor)
{
  auto blocks = std::make_shared<SpaceBlocks>(*scene.blocks);
  for (auto *const strengths :
       {&blocks->strengths.of_interface, &blocks->strengths.coefficient})
    for (double &strength : *strengths)
      strength /= divisor;
  SpaceScene divided = scene;
  divided.blocks = std::move(blocks);
  return divided;
}

template <typename SceneOf>
void check_strength_factor(const SceneOf &scene,
                           const LoadFactorControls &controls)
{
  if (!dilates(scene))
    throw InputError("'Load factor/Factor' is 'strength', and 'Friction/Law' "
                     "is 'Coulomb', for which what is carried with some "
                     "strengths need not be so with greater ones; set the law "
                     "to 'associated Coulomb', or the factor to one of loads.");
  if (!controls.greatest)
    throw InputError("'Load factor/Direction' is 'least', but strengths may be "
                     "multiplied by any number: set it to 'greatest', or "
                     "'Factor' to one of loads.");
  if (!scene.is_loaded())
    throw InputError("'Load factor/Factor' is 'strength', and there are no "
                     "loads to be carried: 'Loads' gives them.");
}

template void check_strength_factor(const Scene &, const LoadFactorControls &);
template void check_strength_factor(const SpaceScene &,
                                    const LoadFactorControls &);
} // namespace Voussoir
