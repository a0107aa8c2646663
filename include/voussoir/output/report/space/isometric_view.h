// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_space_isometric_view_h
#define voussoir_output_report_space_isometric_view_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <cmath>

namespace Voussoir
{
/**
 * The isometric projection seen from (1, -1, 1): x runs to the right and
 * downward, y to the right and upward, z upward, all at the same scale, which
 * is sqrt(2/3) of that in space.
 */
struct IsometricView
{
  /** The point that is projected on the origin; a length. */
  dealii::Point<3> centre;
  /** The length that is one in the picture, before the projection. */
  double unit = 1.;
  /** The unit vector that runs to the right in the picture. */
  dealii::Tensor<1, 3> right{{std::sqrt(1. / 2.), std::sqrt(1. / 2.), 0.}};
  /** The unit vector that runs upward in the picture. */
  dealii::Tensor<1, 3> up{
      {-std::sqrt(1. / 6.), std::sqrt(1. / 6.), std::sqrt(2. / 3.)}};
  /** The unit vector towards the viewer. */
  dealii::Tensor<1, 3> towards{
      {std::sqrt(1. / 3.), -std::sqrt(1. / 3.), std::sqrt(1. / 3.)}};

  /** The place in space from the centre on, in units. */
  dealii::Point<3> in_units(const dealii::Point<3> &p) const
  {
    return dealii::Point<3>((p - centre) / unit);
  }
  /** The place in the picture, to the right and upward, in units. */
  dealii::Point<2> place(const dealii::Point<3> &p) const
  {
    return {right * in_units(p), up * in_units(p)};
  }
  /** The distance from the centre towards the viewer, in units. */
  double nearness(const dealii::Point<3> &p) const
  {
    return towards * in_units(p);
  }
};
} // namespace Voussoir

#endif
