// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_vector_expression_h
#define voussoir_formula_vector_expression_h

#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/formula/expression.h>

#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

namespace Voussoir
{
/** Expressions "f_x; f_y" in x, y, ... as a user wrote them; there may be more.
 */
class VectorExpression
{
public:
  /** As for Expression. */
  VectorExpression(const std::string &formulas,
                   const std::vector<std::string> &variables,
                   const std::string &parameter)
      : parameter(parameter)
  {
    // With an empty one behind the last semicolon, too, which is refused.
    boost::algorithm::split(components, formulas,
                            [](const char c) { return c == ';'; });
    for (std::string &component : components)
    {
      boost::algorithm::trim(component);
      f.emplace_back(component, variables, parameter);
    }
  }

  /** The number of components. */
  unsigned int size() const { return f.size(); }

  /** True if all are zero everywhere by their form. */
  bool is_zero() const
  {
    return std::all_of(f.begin(), f.end(),
                       [](const Expression &of) { return of.is_zero(); });
  }

  /** True if all are the same everywhere by their form. */
  bool is_constant() const
  {
    return std::all_of(f.begin(), f.end(),
                       [](const Expression &of) { return of.is_constant(); });
  }

  /** The operations of a component, to know where it jumps. */
  const Formula &formula(const unsigned int i) const { return f[i].formula(); }

  /**
   * The value of component @p i for one value of each variable, x and y first.
   *
   * @throws InputError that ends with @p where if it is not finite.
   */
  template <typename Where>
  double component(const unsigned int i,
                   const std::initializer_list<double> values,
                   const Where &where) const
  {
    const double value = f[i](values);
    if (!std::isfinite(value))
      throw InputError(
          text("'", parameter, "' has the component '", components[i],
               "', which is ", text_of_number(value), " at ",
               text_of_point({values.begin()[0], values.begin()[1]}), where()));
    return value;
  }

  /** The same in space, at @p x. */
  double component(const unsigned int i,
                   const std::vector<double> &values,
                   const dealii::Point<3> &x,
                   const std::string &where) const
  {
    const double value = f[i](values);
    if (!std::isfinite(value))
      throw InputError(text("'", parameter, "' has the component '",
                            components[i], "', which is ",
                            text_of_number(value), " at ", text_of_point(x),
                            where));
    return value;
  }

private:
  std::vector<std::string> components;
  std::string parameter;
  std::vector<Expression> f;
};
} // namespace Voussoir

#endif
