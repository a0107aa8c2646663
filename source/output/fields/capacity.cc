// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/capacity.h>

namespace Voussoir
{
Fields<CapacityCurve> capacity_points()
{
  const auto member = [](const auto of) {
    return [of](const CapacityCurve &c) { return Stored(c.points, of); };
  };
  const FieldCondition<CapacityCurve> with_supports = {
      "with `Supports/Displacement`",
      [](const CapacityCurve &c) { return c.has_moving_supports; }};
  const Fields<CapacityCurve> of_factor = {
      {"displacement", "L", "the displacement of the point, in its direction",
       member(&CapacityPoint::displacement)},
      {"carried", "", "the factor that is carried there",
       member(&CapacityPoint::carried)},
      {"bound", "", "the factor that its mechanism proves to be the most",
       member(&CapacityPoint::bound)},
      {"error_of_state", "",
       "the largest error of the forces that carry it, as in the "
       "[certificate](theory.md#the-certificate)",
       member(&CapacityPoint::error_of_state)}};
  const Fields<CapacityCurve> of_supports = when(
      with_supports,
      Fields<CapacityCurve>{
          {"of_supports", "L",
           "the displacement of the support that has gone farthest",
           member(&CapacityPoint::of_supports)},
          {"support_force", "S L",
           "the least force of the dead loads against the displacement of the "
           "supports, as a thrust is: minus the work of the ground over the "
           "largest displacement",
           member(&CapacityPoint::support_force)},
          {"least_support_force", "S L",
           "what the motion proves to be the least",
           member(&CapacityPoint::least_support_force)}});
  Fields<CapacityCurve> points =
      together<CapacityCurve>({of_factor, of_supports});
  for (Field<CapacityCurve> &field : points)
    field.with_attribute("capacity_" + field.name);
  return points;
}
} // namespace Voussoir
