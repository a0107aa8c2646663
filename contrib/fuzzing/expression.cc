// SPDX-License-Identifier: LGPL-2.1-or-later

// Expressions in x and y, their values, their bounds and where they jump.

#include <voussoir/base/floating_point.h>
#include <voussoir/formula/expression.h>
#include <voussoir/formula/integrals/discontinuities.h>

#include "harness.h"

namespace
{
const Fuzzing::Target of_expression("expression", [](const std::string &input) {
  using namespace Voussoir;
  const Expression expression(input, {"x", "y"}, "Section/Name");
  const Formula &formula = expression.formula();
  const Discontinuities jumps({formula}, {});
  const InvalidOperationsAllowed allowed;
  for (const double x : {-1., 0., 1e-300, 1e300})
  {
    expression({x, 1.});
    formula.value({x, 1.});
    const Patch patch = box_around({{x, 0.}, {x + 1., 1.}});
    jumps.bounds_in(patch, jumps.no_limits());
    for (const auto &crossing : jumps.crossings(patch, jumps.no_limits()))
    {
      jumps.distance(crossing, patch.centre);
      jumps.is_step(crossing, patch.centre, jumps.no_limits());
    }
  }
});
} // namespace
