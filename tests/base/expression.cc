// SPDX-License-Identifier: LGPL-2.1-or-later

// Expressions: values of the functions that the manual promises, and what a
// user is told about a formula that cannot be parsed.

#include <voussoir/formula/expression.h>

#include "tests.h"

namespace test_expression
{
using Voussoir::Expression;

double value(const std::string &formula)
{
  return Expression(formula, {"x", "y"}, "Test")({2., -3.});
}

void run()
{
  check_error("x + 2 y^2", std::abs(value("x + 2*y^2") - 20.), 1e-15);
  check_error("if", std::abs(value("if(x > 1, 5, 6)") - 5.), 0.);
  check_error("?:", std::abs(value("y > 0 && x > 0 ? 5 : 6") - 6.), 0.);
  check_error("pow, floor, ceil",
              std::abs(value("pow(x, 3) + floor(y / 2) + ceil(y / 2)") - 5.),
              1e-15);
  check_error("sin(pi)", std::abs(value("sin(pi)")), 1e-15);
  check("0/0 is NaN", std::isnan(value("0/0")));

  show_refusal([] { value("x +* 2"); });
  show_refusal([] { value("x + z"); });
  show_refusal([] { value(""); });
  show_refusal([] { value("x = 0.5 ? 1 : 2"); });
  show_refusal([] { value("1, 2"); });
}

const RoomTest test("expression", run);
} // namespace test_expression
