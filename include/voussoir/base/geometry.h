// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_geometry_h
#define voussoir_base_geometry_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Voussoir
{
/**
 * Twice the area of the triangle between two vectors, a_x b_y - a_y b_x:
 * positive if @p b points to the left of @p a; L^2.
 */
inline double cross(const dealii::Tensor<1, 2> &a,
                    const dealii::Tensor<1, 2> &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/** The rotation by an angle, counterclockwise. */
inline dealii::Tensor<2, 2> rotation_by(const double angle)
{
  dealii::Tensor<2, 2> rotation;
  rotation[0][0] = rotation[1][1] = std::cos(angle);
  rotation[1][0] = std::sin(angle);
  rotation[0][1] = -rotation[1][0];
  return rotation;
}

/** The point of the segment from @p a to @p b that is nearest to @p p. */
template <int dim>
dealii::Point<dim> nearest_on_segment(const dealii::Point<dim> &p,
                                      const dealii::Point<dim> &a,
                                      const dealii::Point<dim> &b)
{
  const dealii::Tensor<1, dim> along = b - a;
  const double square = along.norm_square();
  return square > 0. ? a + std::clamp((p - a) * along / square, 0., 1.) * along
                     : a;
}

/**
 * The area of a loop of vertices, negative if it runs clockwise; L^2. By
 * triangles from the first vertex, so that a distant origin cancels nothing.
 */
inline double signed_area(const std::vector<dealii::Point<2>> &loop)
{
  double area = 0.;
  for (unsigned int i = 1; i + 1 < loop.size(); ++i)
    area += 0.5 * cross(loop[i] - loop[0], loop[i + 1] - loop[0]);
  return area;
}
} // namespace Voussoir

#endif
