// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/scene/proofs/utilisation.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/** A force, over the largest of the state, that is rounding. */
constexpr double rounding_of_no_force = 1e-12;
} // namespace

Utilisation::Utilisation(const Scene &scene, const InterfaceForces &forces)
    : scene(scene), forces(forces)
{
  double largest = 0.;
  for (const auto *of : {&forces.normal, &forces.tangential})
    for (const double f : *of)
      largest = std::max(largest, std::abs(f));
  rounding = rounding_of_no_force * largest;
}

double Utilisation::operator()(const unsigned int e) const
{
  const double normal = forces.normal[e], tangential = forces.tangential[e];
  if (std::abs(tangential) <= rounding)
    return 0.;
  return std::abs(tangential) / scene.limits(e).shear_strength(normal);
}
} // namespace Voussoir
