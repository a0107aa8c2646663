// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_voronoi_cell_size_h
#define voussoir_packing_voronoi_cell_size_h

#include <voussoir/formula/expression.h>

#include <deal.II/base/point.h>

#include <string>

namespace Voussoir
{
/**
 * The size h(x, y), or h(x, y, z), that the cells of a packing are wanted to
 * have, up to a factor: a positive formula of the place.
 */
template <int dim>
class CellSize
{
public:
  /**
   * @param parameter the parameter that the formula came from, for messages.
   * @throws InputError if the formula cannot be parsed.
   */
  CellSize(const std::string &formula, const std::string &parameter);

  /**
   * h at @p p, in a unit that cancels.
   *
   * @throws InputError naming the place if it is not positive and finite.
   */
  double operator()(const dealii::Point<dim> &p) const;

  /** True if the formula does not depend on the place. */
  bool is_constant() const { return expression.is_constant(); }

  /**
   * Refuse a size that comes too near to zero, or changes too much, at @p p.
   *
   * @throws InputError always.
   */
  [[noreturn]] void refuse_as_too_small(const dealii::Point<dim> &p) const;

private:
  std::string formula;
  std::string parameter;
  Expression expression;
};
} // namespace Voussoir

#endif
