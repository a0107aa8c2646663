// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_loads_body_force_h
#define voussoir_scene_loads_body_force_h

#include <voussoir/formula/integrals/discontinuities.h>
#include <voussoir/formula/integrals/inaccuracies.h>
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
   * The integrals of b(x); see triangle_integral().
   *
   * @param packing has the cells.
   * @param b gives the body force, S/L, at a point of the cell of a number. It
   *   may throw.
   * @param jumps of b.
   * @param inaccuracies look at each integral, if given.
   */
  BodyForce(const Packing<2> &packing,
            const std::function<dealii::Tensor<1, 2>(const dealii::Point<2> &,
                                                     unsigned int)> &b,
            const Discontinuities &jumps = Discontinuities(),
            Inaccuracies *inaccuracies = nullptr);

  /** Add a body force on some @p cells, which have had none. */
  void add(const Packing<2> &packing,
           const std::vector<unsigned int> &cells,
           const std::function<dealii::Tensor<1, 2>(const dealii::Point<2> &,
                                                    unsigned int)> &b,
           const Discontinuities &jumps,
           Inaccuracies *inaccuracies);

  /** Add the force @p f, per unit thickness, spread evenly over @p cell. */
  void add(const Packing<2> &packing,
           unsigned int cell,
           const dealii::Tensor<1, 2> &f);
  /**
   * Add the force @p f that acts at a place, spread over @p cell: evenly, and
   * its torque about the centroid x_g by the field torque / I R(pi/2) (x - x_g)
   * with the polar moment I about x_g. Only about the centroid has that no
   * resultant.
   */
  void add(const Packing<2> &packing,
           unsigned int cell,
           const dealii::Tensor<1, 2> &f,
           const dealii::Point<2> &place);

  /** Add @p factor times another body force on the same packing. */
  void add(double factor, const BodyForce &other);

  /**
   * The body force of cells that have turned by these angles about their
   * centres: it keeps its directions, and acts at the same points of them.
   */
  BodyForce turned(const std::vector<double> &angles) const;

  /**
   * The body force A b, times the share of each cell.
   *
   * @param packing has the cells.
   * @param A a linear map.
   * @param share_of_cell by cell.
   */
  BodyForce transformed(const Packing<2> &packing,
                        const dealii::Tensor<2, 2> &A,
                        const std::vector<double> &share_of_cell) const;

  /** True if there is none, and none was added. */
  bool empty() const { return on_sub_cell.empty(); }

  /** The force on @p cell; S L. */
  dealii::Tensor<1, 2> force(const Packing<2> &packing,
                             unsigned int cell) const;
  /** The force on sub-cell @p i of @p cell, which lies along its side i; S L.
   */
  dealii::Tensor<1, 2>
  force(const Packing<2> &packing, unsigned int cell, unsigned int i) const;
  /**
   * The integral over @p cell of the outer product of b and x - x_c: component
   * ij is that of b_i (x - x_c)_j; S L^2.
   */
  dealii::Tensor<2, 2> moment(unsigned int cell) const;
  /** The torque about x_c on @p cell, positive counterclockwise; S L^2. */
  double torque(unsigned int cell) const;

private:
  void allocate(const Packing<2> &packing);

  /** By packing.first_side(cell) + i. */
  std::vector<dealii::Tensor<1, 2>> on_sub_cell;
  std::vector<dealii::Tensor<2, 2>> moment_of_cell;
};
} // namespace Voussoir

#endif
