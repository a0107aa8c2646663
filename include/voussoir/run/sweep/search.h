// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_sweep_search_h
#define voussoir_run_sweep_search_h

#include <voussoir/run/sweep/many_runs.h>
#include <voussoir/run/sweep/sweep_values.h>
#include <voussoir/terminal/terminal.h>

namespace Voussoir
{
/**
 * Look for the value of a parameter at which the verdict changes, between
 * values at which the load is carried and collapses, each by its certificate.
 * The search is right if it changes once in the range. Write sweep.csv and
 * sweep.html with all runs, and all results of the two at the end into
 * `carried` and `collapses`.
 *
 * @throws InputError if a value is wrong, or both ends have the same verdict.
 * @throws SolverError if a run has no verdict, with its value.
 */
void search(const ManyRuns &runs, const SearchRange &range, Terminal &terminal);
} // namespace Voussoir

#endif
