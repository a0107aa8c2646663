// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_functions_h
#define voussoir_formula_functions_h

#include <voussoir/formula/bounds.h>

#include <functional>
#include <string>
#include <vector>

namespace Voussoir
{
/** A function of one variable that formulas may use, smooth where it is real.
 */
struct SmoothFunction
{
  /** Its name in formulas. */
  std::string name;
  /** The function. */
  double (*value)(double);
  /** The bounds of the function of what has the bounds given. */
  std::function<Bounds(const Bounds &)> bounds;
};

/** All smooth functions. */
const std::vector<SmoothFunction> &smooth_functions();

/** A function of one variable that has steps or kinks. */
struct SteppedFunction
{
  /** Its name in formulas. */
  std::string name;
  /** The function. */
  double (*value)(double);
  /** The steps or kinks are at first_step + k period, k any integer. */
  double first_step;
  /** Zero if there is one step only. */
  double period;
};

/** All of them: abs, sign, floor, ceil, rint. */
const std::vector<SteppedFunction> &stepped_functions();
} // namespace Voussoir

#endif
