// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_body_force_h
#define voussoir_statics_body_force_h

#include <voussoir/packing/packing.h>

#include <deal.II/base/tensor.h>

#include <functional>
#include <vector>

namespace Voussoir
{
/**
 * A body force b, integrated over the cells of a packing and over their
 * sub-cells, the triangles of the centre and one side. Without any body force
 * it is empty, and costs nothing.
 */
class BodyForce
{
public:
  /** No body force. */
  BodyForce() = default;

  /**
   * The integrals of b(x), a force per unit area and thickness, by a rule that
   * is exact for polynomials of degree 5, and for torques those of degree 4. @p
   * b is given the point and the number of the cell.
   */
  BodyForce(const Packing &packing,
            const std::function<dealii::Tensor<1, 2>(const dealii::Point<2> &,
                                                     unsigned int)> &b);

  /** Add the force @p f per unit thickness, spread evenly over @p cell. */
  void
  add(const Packing &packing, unsigned int cell, const dealii::Tensor<1, 2> &f);

  bool empty() const;
  /** The force on @p cell; per unit thickness. */
  dealii::Tensor<1, 2> force(const Packing &packing, unsigned int cell) const;
  /** The force on sub-cell @p i of @p cell, which lies along its side i. */
  dealii::Tensor<1, 2>
  force(const Packing &packing, unsigned int cell, unsigned int i) const;
  /** The integral of b (x) (x - x_c) over @p cell; a force times a length. */
  dealii::Tensor<2, 2> moment(unsigned int cell) const;

private:
  void allocate(const Packing &packing);

  /** By packing.first_side(cell) + i. */
  std::vector<dealii::Tensor<1, 2>> on_sub_cell;
  std::vector<dealii::Tensor<2, 2>> moment_of_cell;
};
} // namespace Voussoir

#endif
