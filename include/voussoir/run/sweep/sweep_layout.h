// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_sweep_sweep_layout_h
#define voussoir_run_sweep_sweep_layout_h

#include <voussoir/run/sweep/repeated_run.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace Voussoir
{
/** What changes in a sweep, with its values. */
struct SweptEntry
{
  std::string name;
  /** Each value once: ascending if all are numbers, else in their order. */
  std::vector<std::string> values;
  /** The values as numbers; none if some are words. */
  std::vector<double> numbers;

  /** True if they are positive and have much the same ratios. */
  bool is_by_ratio() const;
};

/** How many runs are drawn: a curve for each combination of all entries but
 * one, over this, or a map over two. */
struct SweepLayout
{
  /** The ways to draw them. */
  enum class Form
  {
    curves,
    map,
    /** Too many combinations to be drawn. */
    table
  };

  Form form = Form::curves;
  /** The entry along the axis of x. */
  SweptEntry along;
  /** That along the other one of a map. */
  SweptEntry across;
  /** The names of the other entries that change. */
  std::vector<std::string> others;
  /** The words of each curve, "Axles = LM2, Reversed = true"; empty if it is
   * the only one. */
  std::vector<std::string> labels;
  /** By the number of the curve, and of the value along x: the number of the
   * run, or no_run. */
  std::vector<std::vector<std::size_t>> runs;

  /** Stands for a run that is not there. */
  static constexpr std::size_t no_run = std::numeric_limits<std::size_t>::max();
};

/**
 * Along x is the entry with the most numbers, or words if none has numbers.
 *
 * @param names of the entries.
 * @param runs at least one.
 */
SweepLayout layout_of(const std::vector<std::string> &names,
                      const std::vector<SweepRun> &runs);

/** The last parts of names of entries, where these differ. */
std::vector<std::string> short_names(const std::vector<std::string> &names);

/** A value in a sentence: a long number with four digits. */
std::string short_value(const std::string &value);

/** "Axles = LM2, Position = -5.533": words_of() with four digits. */
std::string short_words_of(const std::vector<std::string> &names,
                           const std::vector<std::string> &values);
} // namespace Voussoir

#endif
