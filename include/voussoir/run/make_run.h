// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_make_run_h
#define voussoir_run_make_run_h

#include <voussoir/parallel/process_group.h>
#include <voussoir/run/run.h>
#include <voussoir/terminal/terminal.h>

#include <memory>

namespace Voussoir
{
/**
 * The entry `Dimension` as the sources have it, 2 or 3; 2 if it is not there,
 * or is neither, which reading them refuses.
 *
 * @throws InputError as ParameterInput does.
 */
unsigned int dimension_of(const ParameterSources &sources);

/**
 * A run that has read @p sources, of the kind that their entry `Dimension` asks
 * for.
 *
 * @param terminal sees what the run notices.
 * @param processes the processes that help, beside this one, its root.
 * @throws InputError as Run::read() does.
 */
std::unique_ptr<Run> make_run(const ParameterSources &sources,
                              Terminal &terminal,
                              const ProcessGroup &processes = ProcessGroup());
} // namespace Voussoir

#endif
