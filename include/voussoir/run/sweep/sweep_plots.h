// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_sweep_sweep_plots_h
#define voussoir_run_sweep_sweep_plots_h

#include <voussoir/run/sweep/envelope.h>
#include <voussoir/run/sweep/sweep_files.h>
#include <voussoir/run/sweep/sweep_layout.h>

#include <string>
#include <vector>

namespace Voussoir
{
/**
 * Plots of the load factor, the utilisation, the work of mechanisms, and of
 * further numbers, as HTML: curves with their key, or maps; or the sentence why
 * there are none. What is without bound, or without a number since it is not
 * carried or has no answer, is told below each.
 *
 * @param results further numbers, as in write_sweep_csv().
 */
std::string plots_of(const SweepLayout &layout,
                     const Envelope &envelope,
                     const std::vector<std::string> &results,
                     const std::vector<SweepRun> &runs);
} // namespace Voussoir

#endif
