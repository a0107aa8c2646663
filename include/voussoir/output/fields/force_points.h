// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_force_points_h
#define voussoir_output_fields_force_points_h

#include <voussoir/output/fields/field_table.h>
#include <voussoir/output/space_results.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace Voussoir
{
/** A point of an interface in space at which a force acts. */
struct ForcePoint
{
  unsigned int interface;     /**< the number of the interface */
  bool presses;               /**< true of FacePoints::pressure */
  double share;               /**< FacePoint::share */
  dealii::Point<3> place;     /**< where it is; a length */
  dealii::Tensor<1, 3> force; /**< on c-; S L^2 */
};

/** The points of all interfaces, in the order of these. */
struct ForcePoints
{
  /** Those of @p answer; none if nothing was asked. */
  explicit ForcePoints(const SpaceResults &answer);

  std::vector<ForcePoint> list; /**< the points */
  bool have_forces;             /**< false if the loads are not carried */
};

/** The quantities of these points. */
const FieldTable<ForcePoints> &force_point_fields();
} // namespace Voussoir

#endif
