// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/factors/check_strength_factor.h>
#include <voussoir/base/exceptions.h>

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
