// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_expression_h
#define voussoir_formula_expression_h

#include <voussoir/formula/formula.h>

#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

namespace Voussoir
{
/**
 * A formula that the user wrote, evaluated by muParser: + - * / ^, comparisons,
 * &&, ||, the conditional c ? a : b, if(c, a, b), sin, cos, tan, sqrt, exp,
 * log, abs, min, max, pow, floor, ceil, ... and the constant pi.
 */
class Expression
{
public:
  /**
   * @param formula the text of the formula.
   * @param variables the names it may use, in the order of the values that
   *   operator() takes.
   * @param parameter the parameter that the formula came from, for messages.
   * @throws InputError if the formula cannot be parsed.
   */
  Expression(const std::string &formula,
             const std::vector<std::string> &variables,
             const std::string &parameter);
  ~Expression();
  /** @{ */
  /** Moved, not copied: a parser has the addresses of its variables. */
  Expression(Expression &&) noexcept;
  Expression &operator=(Expression &&) noexcept;
  /** @} */

  /**
   * The value of the formula for one value of each variable; it may be infinite
   * or NaN, which is for the caller to refuse, who knows where it was asked
   * for. Not thread safe.
   */
  double operator()(const std::vector<double> &values) const;
  /** The value for a list that is not stored. */
  double operator()(std::initializer_list<double> values) const;

  /** True if the formula uses none of the variables. */
  bool is_constant() const;

  /** True if it is zero everywhere by its form. */
  bool is_zero() const;

  /** Its operations, to know where it jumps. */
  const Formula &formula() const;

private:
  struct Implementation;
  double value() const;

  std::unique_ptr<Implementation> implementation;
};

/** True if @p name is a function of expressions, or the constant. */
bool is_function_or_constant(const std::string &name);

/** An Expression in x, y, ... that chooses places: where it is not zero. */
class Condition
{
public:
  /** As for Expression; the first two variables are x and y, in space z is the
   * third. */
  Condition(const std::string &formula,
            const std::vector<std::string> &variables,
            const std::string &parameter);

  /**
   * True if it holds for one value of each variable, x and y first.
   *
   * @throws InputError naming the place if the value is not a number.
   */
  bool operator()(const std::vector<double> &values) const;

  /** True if it holds nowhere by its form, as 0 does. */
  bool is_never() const { return expression.is_zero(); }

private:
  Expression expression;
  std::string formula, parameter;
  bool is_in_space;
};
} // namespace Voussoir

#endif
