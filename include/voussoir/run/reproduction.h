// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_reproduction_h
#define voussoir_run_reproduction_h

#include <voussoir/parallel/process_group.h>
#include <voussoir/terminal/terminal.h>

#include <filesystem>

namespace Voussoir
{
/**
 * Make results again, of the parameters beside them, and compare. The files go
 * to a directory of their own, which is removed.
 *
 * The terminal shows what differs: where the results were made, the numbers of
 * the summaries, but for times, and the tables, byte by byte. Machines and
 * versions may differ in last digits, and where many forces carry a load in the
 * forces.
 *
 * @param summary the summary.json of a run.
 * @param terminal of the comparison.
 * @param processes the processes that help, beside this one, its root.
 * @return whether the answer is the same: the status, and the bounds of a load
 *   factor, which overlap.
 * @throws InputError if @p summary is none or does not say what it is made of,
 *   if the parameters or files are not those any more, or if the run does;
 *   SolverError as the run.
 */
bool reproduce(const std::filesystem::path &summary,
               Terminal &terminal,
               const ProcessGroup &processes);
} // namespace Voussoir

#endif
