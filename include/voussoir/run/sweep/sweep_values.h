// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_sweep_sweep_values_h
#define voussoir_run_sweep_sweep_values_h

#include <string>
#include <vector>

namespace Voussoir
{
/** A parameter that changes, or a number in its text that does. */
struct ChangingEntry
{
  /** As in "Friction/Strength". */
  std::string entry;
  /** A text with a variable, as in "cos(a); sin(a)"; empty: the value itself.
   */
  std::string text = {};
  /** That variable. */
  std::string variable = {};

  /** What table and messages call it. */
  const std::string &name() const { return text.empty() ? entry : variable; }
  /** The assignment with a @p value, as in --set. */
  std::string assignment(const std::string &value) const;
};

/** A parameter and the values that it takes in a sweep. */
struct SweepAxis
{
  /** What changes. */
  ChangingEntry of;
  /** As they would stand in a .prm file. */
  std::vector<std::string> values;
};

/**
 * Read "Section/Name=VALUES", where VALUES are "start:end:n", n values with
 * equal steps; "start:end:n:log", with equal ratios; or a list "a | b | c", of
 * values that have a bar in them "a || b || c". Or
 * "Section/Name=TEXT for a=VALUES", where each value stands for the word a in
 * the text.
 *
 * @throws InputError if it is none of these.
 */
SweepAxis read_sweep_axis(const std::string &text);

/** All combinations of a value of each axis, the last of which runs fastest. */
std::vector<std::vector<std::string>>
points_of(const std::vector<SweepAxis> &axes);

/** What is looked for: the value of a parameter at which the verdict changes.
 */
struct SearchRange
{
  /** What changes. */
  ChangingEntry of;
  double low;  /**< one end */
  double high; /**< the other, larger */
  /** The distance of the two values to stop at, over the larger size. */
  double width = 1e-6;
};

/**
 * Read "Section/Name=low:high" or "Section/Name=low:high:width", or the same of
 * a variable, see read_sweep_axis().
 *
 * @throws InputError if it is neither.
 */
SearchRange read_search_range(const std::string &text);
} // namespace Voussoir

#endif
