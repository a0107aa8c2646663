// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_vtu_values_h
#define voussoir_output_vtu_values_h

#include <deal.II/base/tensor.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace Voussoir
{
/** Values as VTK has them, in three dimensions and row by row. */
namespace VtuValues
{
/** A number alone. */
template <typename Number>
std::array<Number, 1> scalar(const Number value)
{
  return {{value}};
}

/** A vector in the plane, or the coordinates of a point. */
inline std::array<double, 3> vector(const dealii::Tensor<1, 2> &v)
{
  return {{v[0], v[1], 0.}};
}

/** A tensor in the plane: xx, xy, xz, yx and so on. */
inline std::array<double, 9> tensor(const dealii::Tensor<2, 2> &t)
{
  return {{t[0][0], t[0][1], 0., t[1][0], t[1][1], 0., 0., 0., 0.}};
}

/** What is derived from the symmetric part of a stress, in its unit. */
struct StressInvariants
{
  explicit StressInvariants(const dealii::Tensor<2, 2> &stress)
  {
    // By Mohr's circle.
    const double mean = 0.5 * (stress[0][0] + stress[1][1]);
    const double radius = std::hypot(0.5 * (stress[0][0] - stress[1][1]),
                                     0.5 * (stress[0][1] + stress[1][0]));
    principal_1 = mean + radius;
    principal_2 = mean - radius;
    von_mises =
        std::sqrt(principal_1 * principal_1 - principal_1 * principal_2 +
                  principal_2 * principal_2);
  }

  double principal_1; /**< the larger principal stress */
  double principal_2; /**< the smaller one */
  double von_mises;   /**< of plane stress */
};

/**
 * The cell to which item @p i belongs, such as a point, where the items of cell
 * c are numbered from @p first(c) to first(c + 1) - 1.
 */
template <typename First>
unsigned int
cell_of(const std::size_t i, const unsigned int n_cells, const First &first)
{
  unsigned int begin = 0, end = n_cells;
  while (begin + 1 < end)
  {
    const unsigned int middle = begin + (end - begin) / 2;
    (first(middle) <= i ? begin : end) = middle;
  }
  return begin;
}
} // namespace VtuValues
} // namespace Voussoir

#endif
