// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/parameters/decimal_comma.h>
#include <voussoir/base/text.h>
#include <voussoir/formula/expression.h>
#include <voussoir/formula/formula_reader.h>

#include <boost/algorithm/string/join.hpp>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>

namespace Voussoir
{
struct Expression::Implementation
{
  mu::Parser parser;
  std::vector<double> values;
  bool is_constant = false;
  /** Its value if it is constant. */
  double constant = 0.;
  std::optional<Formula> formula;
};

namespace
{
const std::string name_of_pi = "pi";

std::string what_it_may_use(const std::vector<std::string> &variables)
{
  if (variables.empty())
    return "It may use no variables.";
  return "It may use the variables " + boost::algorithm::join(variables, ", ") +
         ".";
}

[[noreturn]] void refuse(const std::string &formula,
                         const std::string &parameter,
                         const std::vector<std::string> &variables,
                         std::string reason)
{
  if (reason.back() != '.') // some of muParser's messages have none
    reason += '.';
  throw InputError("The parameter '" + parameter + "' has the expression '" +
                   formula + "', which is not valid: " + reason + ' ' +
                   what_it_may_use(variables));
}

/** True if commas between digits are all that keeps it from being one. */
bool is_one_with_decimal_points(const std::string &formula,
                                const std::vector<std::string> &variables)
{
  const std::string corrected = with_decimal_points(formula);
  if (corrected == formula)
    return false;
  try
  {
    const Expression valid(corrected, variables, "");
    return true;
  }
  catch (const InputError &)
  {
    return false;
  }
}
} // namespace

Expression::Expression(const std::string &formula,
                       const std::vector<std::string> &variables,
                       const std::string &parameter)
    : implementation(std::make_unique<Implementation>())
{
  if (formula.find_first_not_of(" \t") == std::string::npos)
    throw InputError("The parameter '" + parameter +
                     "' has an empty expression; write one, such as 1. " +
                     what_it_may_use(variables));
  // muParser would carry out an assignment, which is a comparison mistyped.
  if (std::regex_search(formula, std::regex("(^|[^=!<>])=([^=]|$)")))
    refuse(formula, parameter, variables, "write == to compare.");

  mu::Parser &parser = implementation->parser;
  define_functions(parser);
  implementation->values.resize(variables.size());
  try
  {
    for (unsigned int i = 0; i < variables.size(); ++i)
      parser.DefineVar(variables[i], &implementation->values[i]);
    parser.DefineConst(name_of_pi, 3.14159265358979323846);
    parser.SetExpr(formula);
    // Parsing is lazy: evaluate once, to meet the errors here. What is not a
    // number may be one where the formula will be asked for.
    const InvalidOperationsAllowed allowed;
    int n_results = 0;
    parser.Eval(n_results);
    if (n_results != 1)
      refuse(formula, parameter, variables,
             "one expression was expected, not several" +
                 (is_one_with_decimal_points(formula, variables)
                      ? advice_on_decimal_comma(formula)
                      : "") +
                 ".");
    // Asked once, and of a valid formula: muParser parses anew for it, and is
    // content with names it does not know.
    implementation->is_constant = parser.GetUsedVar().empty();
    implementation->constant = parser.Eval(); // and the byte code again
    implementation->formula = read_formula(parser, implementation->values);
  }
  catch (const mu::ParserError &error)
  {
    refuse(formula, parameter, variables, error.GetMsg());
  }
}

Expression::~Expression() = default;
Expression::Expression(Expression &&) noexcept = default;
Expression &Expression::operator=(Expression &&) noexcept = default;

double Expression::operator()(const std::vector<double> &values) const
{
  std::copy(values.begin(), values.end(), implementation->values.begin());
  return value();
}

double Expression::operator()(const std::initializer_list<double> values) const
{
  std::copy(values.begin(), values.end(), implementation->values.begin());
  return value();
}

double Expression::value() const
{
  if (implementation->is_constant)
    return implementation->constant;
  const InvalidOperationsAllowed allowed;
  return implementation->parser.Eval();
}

bool Expression::is_constant() const
{
  return implementation->is_constant;
}

bool Expression::is_zero() const
{
  return implementation->is_constant && implementation->constant == 0.;
}

const Formula &Expression::formula() const
{
  return *implementation->formula;
}

bool is_function_or_constant(const std::string &name)
{
  mu::Parser parser;
  define_functions(parser);
  return name == name_of_pi || parser.GetFunDef().count(name) > 0;
}

Condition::Condition(const std::string &formula,
                     const std::vector<std::string> &variables,
                     const std::string &parameter)
    : expression(formula, variables, parameter), formula(formula),
      parameter(parameter),
      is_in_space(variables.size() > 2 && variables[2] == "z")
{}

bool Condition::operator()(const std::vector<double> &values) const
{
  const double value = expression(values);
  if (std::isnan(value))
    throw InputError("The condition '" + formula + "' of '" + parameter +
                     "' is not a number at " +
                     (is_in_space
                          ? text_of_point<3>({values[0], values[1], values[2]})
                          : text_of_point({values[0], values[1]})) +
                     "; it must be true or false.");
  return value != 0.;
}
} // namespace Voussoir
