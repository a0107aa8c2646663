// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_integrals_triangle_integral_h
#define voussoir_formula_integrals_triangle_integral_h

#include <voussoir/formula/integrals/discontinuities.h>
#include <voussoir/formula/integrals/samples.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <functional>
#include <optional>

namespace Voussoir
{
/** The integrals of a vector-valued function over a triangle. */
struct TriangleIntegral
{
  /** Of the function; its unit times L^2. */
  dealii::Tensor<1, 2> value;
  /**
   * Of its outer product with the distance from a given origin, component ij
   * that of f_i (x - origin)_j; its unit times L^3.
   */
  dealii::Tensor<2, 2> moment;
  /**
   * The error of the value at most, by estimate, and that of the moment over
   * the root of the area; as the value.
   */
  double error;
  /** The integral of the size of the largest component, roughly. */
  double size;
  /** The values of each component at the points of the rule. */
  std::array<Samples, 2> samples;
  /** The part of the area of which the side of a jump is not known. */
  double uncertain;
};

/**
 * Integrate a function over a triangle.
 *
 * A triangle that @p jumps cross is cut by area_pieces(). On a triangle without
 * a jump a rule of degree five serves where the function is even enough, or
 * cutting it in four changes nothing, and bounds of the function exclude that a
 * peak hides between the points. Else, and where a curve crosses a piece,
 * integrate() goes along one coordinate and then the other, between the sides
 * and the curve.
 *
 * @param corners counterclockwise; lengths.
 * @param origin of the moment.
 * @param f the function; it may throw.
 * @param jumps of the function; its formulas, if any, are those of the two
 *   components.
 */
TriangleIntegral triangle_integral(
    const std::array<dealii::Point<2>, 3> &corners,
    const dealii::Point<2> &origin,
    const std::function<dealii::Tensor<1, 2>(const dealii::Point<2> &)> &f,
    const Discontinuities &jumps);

/**
 * The integral by one application of the rule; nothing if the function is not
 * even enough for it. No bounds are asked for: whether a jump or a peak hides
 * between the points, the caller may ask for many triangles at a time.
 */
std::optional<TriangleIntegral> quick_triangle_integral(
    const std::array<dealii::Point<2>, 3> &corners,
    const dealii::Point<2> &origin,
    const std::function<dealii::Tensor<1, 2>(const dealii::Point<2> &)> &f);
} // namespace Voussoir

#endif
