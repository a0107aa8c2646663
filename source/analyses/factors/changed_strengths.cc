// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/factors/changed_strengths.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace Voussoir
{
namespace
{
/** Lower the strengths that are larger than @p most; joints that do not crush
 * still do not. */
void lower(std::vector<double> &strengths, const double most)
{
  for (double &strength : strengths)
    if (std::isfinite(strength))
      strength = std::min(strength, most);
}
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

Scene with_strengths_up_to(Scene scene, const double most)
{
  lower(scene.strength, most);
  lower(scene.tensile_strength, most);
  lower(scene.compressive_strength, most);
  const double side = std::sqrt(scene.packing.area() / scene.packing.n_cells());
  for (Link &link : scene.links)
  {
    link.most = std::min(link.most, link.rest() + most * side);
    link.least = std::max(link.least, link.rest() - most * side);
  }
  return scene;
}

SpaceScene with_strengths_up_to(SpaceScene scene, const double most)
{
  auto blocks = std::make_shared<SpaceBlocks>(*scene.blocks);
  lower(blocks->strengths.of_interface, most);
  lower(blocks->strengths.tensile, most);
  lower(blocks->strengths.compressive, most);
  scene.blocks = std::move(blocks);
  return scene;
}
} // namespace Voussoir
