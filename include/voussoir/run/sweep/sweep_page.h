// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_sweep_sweep_page_h
#define voussoir_run_sweep_sweep_page_h

#include <voussoir/run/sweep/repeated_run.h>

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** The runs between which the answer of a search changes, by their numbers. */
struct SearchEnds
{
  std::size_t carried, collapses;
  /** True if between them the answer is open. */
  bool is_open = false;
};

/** What the page of a sweep or a search shows. */
struct SweepPage
{
  /** Of the scene; may be empty. */
  const std::string &title;
  /** @{ */
  /** As in write_sweep_csv(); at least one run. */
  const std::vector<std::string> &names;
  const std::vector<std::string> &results;
  const std::vector<SweepRun> &runs;
  /** @} */
  /** Of a search that has found them. */
  std::optional<SearchEnds> ends;
};

/**
 * Write a page with the verdict and the numbers of all runs, plots of them, the
 * envelope of load factors and the least of each curve, and the ways to the
 * pages of runs. Sentences have four digits, tables all.
 */
void write_sweep_html(std::ostream &out, const SweepPage &page);
} // namespace Voussoir

#endif
