// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_command_line_command_line_h
#define voussoir_run_command_line_command_line_h

#include <voussoir/parallel/process_group.h>
#include <voussoir/terminal/screen.h>

#include <iosfwd>
#include <string>
#include <vector>

/**
 * All of the code: geometry, statics, stress and output, in this order; see
 * run_command_line() for the way in, and AnalysisRun for the way through.
 *
 * Tension is positive everywhere. L stands for a length, S for a stress, in the
 * one consistent set of units that the user has; forces are per unit thickness,
 * S L. Nondimensional quantities say so.
 */
namespace Voussoir
{
/** The devices behind the standard streams. */
struct Screens
{
  Screen out;   /**< of what is found */
  Screen error; /**< of what went wrong */
};

/**
 * The program: read the arguments and parameters, run, and report.
 *
 * @param arguments those after the name of the program.
 * @param out takes the stages and the summary.
 * @param error takes the one message of a run that did not solve its scene.
 * @param processes the processes that help; this one is the root.
 * @param screens the devices to which the streams write.
 * @return the exit status: 0 solved, 1 another answer or not proven, 2 bad
 *   input, 3 the load is not carried, 4 the solver failed. Never throws.
 */
int run_command_line(const std::vector<std::string> &arguments,
                     std::ostream &out,
                     std::ostream &error,
                     const ProcessGroup &processes = ProcessGroup(),
                     const Screens &screens = {});
} // namespace Voussoir

#endif
