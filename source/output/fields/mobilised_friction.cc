// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/mobilised_friction.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace Voussoir
{
Fields<Results> mobilised_friction()
{
  return when<Results>(
      {"with Coulomb's friction",
       [](const Results &r) { return !r.scene.coefficient.empty(); }},
      {{"mobilised_angle", "",
        "angle of the force from the normal, in degrees: the angle of friction "
        "that it needs without cohesion; 0 without a force, more than 90 in "
        "tension",
        [](const Results &r, const unsigned int e) {
          const double p = 0. - r.forces.normal[e];
          const double q = std::abs(r.forces.tangential[e]);
          return std::atan2(q, p) * 180. / dealii::numbers::PI;
        }}});
}
} // namespace Voussoir
