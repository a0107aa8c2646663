// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_unit_fluxes_h
#define voussoir_stress_unit_fluxes_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace Voussoir
{
/**
 * The fields of Raviart and Thomas of lowest order, RT_0, on a tetrahedron.
 * Field i is (x - x_i) / (3 V), with the corner x_i and the volume V: its flux
 * out through the facet opposite to corner i is one, and through the others
 * zero.
 */
class UnitFluxes
{
public:
  /** @param corners of which the first three run counterclockwise as seen from
   * outside. */
  explicit UnitFluxes(const std::array<dealii::Point<3>, 4> &corners)
      : corners(corners)
  {
    const dealii::Point<3> &end = corners[3];
    volume = cross_product_3d(corners[0] - end, corners[1] - end) *
             (corners[2] - end) / 6.;
    dealii::Tensor<1, 3> middle;
    for (const dealii::Point<3> &x : corners)
      middle += 0.25 * dealii::Tensor<1, 3>(x);
    for (unsigned int i = 0; i < 4; ++i)
    {
      integrals[i] = (middle - corners[i]) / 3.;
      // The mean of |x - middle|^2 is a twentieth of the sum over corners.
      spread += (middle - corners[i]).norm_square() / (20. * 9.);
    }
  }

  /** Field @p i at @p x. */
  dealii::Tensor<1, 3> value(const unsigned int i,
                             const dealii::Point<3> &x) const
  {
    return (x - corners[i]) / (3. * volume);
  }
  /** The integral of field @p i. */
  const dealii::Tensor<1, 3> &integral(const unsigned int i) const
  {
    return integrals[i];
  }
  /** The integral of the product of two fields. */
  double product(const unsigned int i, const unsigned int j) const
  {
    return (integrals[i] * integrals[j] + spread) / volume;
  }

  /** Negative if the corners run the other way round. */
  double volume;

private:
  std::array<dealii::Point<3>, 4> corners;
  std::array<dealii::Tensor<1, 3>, 4> integrals;
  /** The mean of |x - middle|^2, over nine. */
  double spread = 0.;
};
} // namespace Voussoir

#endif
