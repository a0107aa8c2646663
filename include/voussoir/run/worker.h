// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_worker_h
#define voussoir_run_worker_h

#include <voussoir/parallel/process_group.h>

namespace Voussoir
{
/**
 * Take part, as a worker, in each task that the root calls to, until there is
 * none left.
 */
void run_worker(const ProcessGroup &processes);
} // namespace Voussoir

#endif
