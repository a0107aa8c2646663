// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_mpi_processes_h
#define voussoir_tests_mpi_processes_h

#include <voussoir/parallel/begin_mpi.h>
#include <voussoir/parallel/process_group.h>
#include <voussoir/run/worker.h>

#include <deal.II/base/multithread_info.h>

#include <fstream>
#include <iostream>

/** Run a test on the root of all processes, for which the others work. */
template <typename Test>
void run_on_processes(const Test &test)
{
  Voussoir::begin_mpi();
  dealii::MultithreadInfo::set_thread_limit(1);
  const Voussoir::ProcessGroup processes(MPI_COMM_WORLD);
  if (!processes.is_root())
    return Voussoir::run_worker(processes);
  // Into a file: the launcher may have something to say on the terminal.
  std::ofstream file("output");
  std::streambuf *const terminal = std::cout.rdbuf(file.rdbuf());
  test(processes);
  std::cout.rdbuf(terminal);
  processes.call("");
}

#endif
