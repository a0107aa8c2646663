// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/force_points.h>

namespace Voussoir
{
ForcePoints::ForcePoints(const SpaceResults &answer)
    : have_forces(answer.is_carried())
{
  if (!answer.is_analysed)
    return;
  const FaceForces &forces = answer.forces;
  const auto &points = answer.scene.blocks->points;
  for (unsigned int e = 0; e < points.size(); ++e)
  {
    unsigned int k = have_forces ? forces.first[e] : 0;
    for (const bool presses : {true, false})
      for (const FacePoint &point :
           presses ? points[e].pressure : points[e].friction)
      {
        list.push_back({e, presses, point.share, point.place, {}});
        // Without a strength the points of friction have no forces.
        if (have_forces && k < forces.first[e + 1])
          list.back().force = forces.list[k++].force;
      }
  }
}

const FieldTable<ForcePoints> &force_point_fields()
{
  static const FieldTable<ForcePoints> table(
      "",
      Fields<ForcePoints>{
          Field<ForcePoints>("interface", "", "the number of its interface",
                             [](const ForcePoints &of, const unsigned int k) {
                               return int(of.list[k].interface);
                             })
              .with_attribute("point_interface"),
          Field<ForcePoints>("pressure", "", "1 if it bears pressure",
                             [](const ForcePoints &of, const unsigned int k) {
                               return of.list[k].presses;
                             })
              .with_attribute("point_pressure"),
          Field<ForcePoints>("share", "", "its share of the area",
                             [](const ForcePoints &of) {
                               return Stored(of.list, &ForcePoint::share);
                             })
              .with_attribute("point_share"),
          Field<ForcePoints>("place", "L", "its place",
                             [](const ForcePoints &of) {
                               return Stored(of.list, &ForcePoint::place);
                             })
              .with_columns({"x", "y", "z"})
              .with_attribute("points")},
      when<ForcePoints>({"with loads that are carried",
                         [](const ForcePoints &of) { return of.have_forces; }},
                        {Field<ForcePoints>("force", "S L^2", "the force on c-",
                                            [](const ForcePoints &of) {
                                              return Stored(of.list,
                                                            &ForcePoint::force);
                                            })
                             .with_attribute("point_forces")}));
  return table;
}
} // namespace Voussoir
