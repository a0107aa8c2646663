// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_area_moments_h
#define voussoir_packing_area_moments_h

#include <voussoir/packing/packing.h>

#include <deal.II/base/tensor.h>

namespace Voussoir
{
/** The moments of the area of a cell about its centre x_c, which is inside. */
struct AreaMoments
{
  /** |c|; L^2. */
  double area;
  /** The integral of x - x_c, zero where x_c is the centroid; L^3. */
  dealii::Tensor<1, 2> first;
  /** The integral of the outer product of x - x_c with itself; L^4. */
  dealii::Tensor<2, 2> second;

  /** The centroid less x_c; a length. */
  dealii::Tensor<1, 2> centroid() const { return first / area; }
  /** AreaMoments::second about the centroid instead; L^4. */
  dealii::Tensor<2, 2> second_about_centroid() const
  {
    return second - outer_product(first, first) / area;
  }
};

/** By the triangles between the centre and the sides, exact for any polygon. */
AreaMoments area_moments(const Packing<2> &packing, unsigned int cell);
} // namespace Voussoir

#endif
