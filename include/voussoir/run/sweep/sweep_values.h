// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_sweep_sweep_values_h
#define voussoir_run_sweep_sweep_values_h

#include <string>
#include <vector>

namespace Voussoir
{
/** A parameter and the values that it takes in a sweep. */
struct SweepAxis
{
  /** As in "Friction/Strength". */
  std::string name;
  /** As they would stand in a .prm file. */
  std::vector<std::string> values;
};

/**
 * Read "Section/Name=VALUES", where VALUES are "start:end:n", n values with
 * equal steps; "start:end:n:log", with equal ratios; or a list "a | b | c".
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
  /** As in "Friction/Strength". */
  std::string name;
  double low;  /**< one end */
  double high; /**< the other, larger */
  /** The distance of the two values to stop at, over the larger size. */
  double width = 1e-6;
};

/**
 * Read "Section/Name=low:high" or "Section/Name=low:high:width".
 *
 * @throws InputError if it is neither.
 */
SearchRange read_search_range(const std::string &text);

/** The shortest text that is read as @p value again. */
std::string value_text(double value);
} // namespace Voussoir

#endif
