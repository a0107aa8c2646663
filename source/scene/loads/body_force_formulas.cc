// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/formula/integrals/inaccuracies.h>
#include <voussoir/formula/value_list.h>
#include <voussoir/formula/vector_expression.h>
#include <voussoir/packing/area_moments.h>
#include <voussoir/packing/group_names.h>
#include <voussoir/scene/loads/body_force_formulas.h>
#include <voussoir/scene/loads/loaded_cells.h>

#include <utility>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** Add the body force @p b, the same everywhere in cell @p c. */
void add_evenly(const Packing<2> &packing,
                const unsigned int c,
                const Tensor<1, 2> &b,
                BodyForce &force,
                Resultant &requested)
{
  const Tensor<1, 2> f = packing.area(c) * b;
  force.add(packing, c, f);
  requested.add(packing.centre(c) + area_moments(packing, c).centroid(), f);
}

/** Add the body forces on some cells of the lists of all. */
void add_lists(const Packing<2> &packing,
               const std::vector<unsigned int> &cells,
               const TextOfParameter &lists,
               BodyForce &force,
               Resultant &requested)
{
  const auto b = vectors_of_lists(lists.value, lists.parameter, 2,
                                  packing.n_cells(), "cell");
  for (const unsigned int c : cells)
    if (const Tensor<1, 2> of_c({b[0][c], b[1][c]}); of_c.norm() > 0.)
      add_evenly(packing, c, of_c, force, requested);
}

/** Add the body force @p b on some cells. */
void add_formula(const Packing<2> &packing,
                 const std::vector<unsigned int> &cells,
                 const VectorExpression &b,
                 const std::string &parameter,
                 BodyForce &force,
                 std::vector<std::string> &warnings,
                 Resultant &requested)
{
  const auto value = [&](const Point<2> &p, const unsigned int cell) {
    const auto where = [&] {
      return text(", in cell ", cell, "; a force must be finite.");
    };
    return Tensor<1, 2>({b.component(0, {p[0], p[1]}, where),
                         b.component(1, {p[0], p[1]}, where)});
  };
  if (b.is_zero())
    return;
  if (b.is_constant())
  {
    for (const unsigned int c : cells)
      add_evenly(packing, c, value(packing.centre(c), c), force, requested);
    return;
  }
  Inaccuracies inaccuracies(parameter);
  force.add(packing, cells, value,
            Discontinuities({b.formula(0), b.formula(1)}, {}), &inaccuracies);
  for (const unsigned int c : cells)
    requested.add(packing.centre(c), force.force(packing, c), force.torque(c));
  for (std::string &warning : inaccuracies.warnings())
    warnings.push_back(std::move(warning));
}
} // namespace

BodyForce body_force_of_formulas(const Packing<2> &packing,
                                 const TextOfParameter &everywhere,
                                 const TextOfParameter &of_groups,
                                 std::vector<std::string> &warnings,
                                 Resultant &requested)
{
  BodyForce force;
  std::vector<bool> has_own(packing.n_cells(), false);
  const auto &[parameter, list] = of_groups;
  for (const auto &[name, value] : split_named_list(list, parameter, true))
  {
    const std::vector<unsigned int> cells =
        new_cells(packing, name, parameter, has_own);
    const VectorExpression b(value, {"x", "y"}, parameter);
    if (b.size() != 2)
      throw InputError("The parameter '" + parameter + "' gives '" + name +
                       "' the body force '" + value +
                       "'; two components \"b_x; b_y\" are expected, and a "
                       "bar | before the next name.");
    add_formula(packing, cells, b, parameter, force, warnings, requested);
  }
  std::vector<unsigned int> others;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    if (!has_own[c])
      others.push_back(c);
  if (is_value_list(everywhere.value))
    add_lists(packing, others, everywhere, force, requested);
  else
    add_formula(
        packing, others,
        VectorExpression(everywhere.value, {"x", "y"}, everywhere.parameter),
        everywhere.parameter, force, warnings, requested);
  return force;
}
} // namespace Voussoir
