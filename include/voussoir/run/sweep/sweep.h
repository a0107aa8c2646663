// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_sweep_sweep_h
#define voussoir_run_sweep_sweep_h

#include <voussoir/run/sweep/many_runs.h>
#include <voussoir/run/sweep/sweep_values.h>
#include <voussoir/terminal/terminal.h>

#include <vector>

namespace Voussoir
{
/**
 * Run a scene with all combinations of the values of @p axes, as many at a time
 * as there are cores, and write sweep.csv and sweep.html into its output
 * directory. With load factors say between which they are, and where, and what
 * the envelope of several curves says.
 *
 * @throws InputError if some values are wrong: then nothing is written.
 * @throws SolverError if the solver failed in some runs; all are written.
 */
void sweep(const ManyRuns &runs,
           const std::vector<SweepAxis> &axes,
           Terminal &terminal);
} // namespace Voussoir

#endif
