// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/capacity.h>

namespace Voussoir
{
Fields<CapacityCurve> capacity_points()
{
  const auto member = [](const auto of) {
    return [of](const CapacityCurve &c) { return Stored(c.points, of); };
  };
  Fields<CapacityCurve> points = {
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
  for (Field<CapacityCurve> &field : points)
    field.with_attribute("capacity_" + field.name);
  return points;
}
} // namespace Voussoir
