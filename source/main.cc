// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/blas.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/memory.h>
#include <voussoir/parallel/begin_mpi.h>
#include <voussoir/run/command_line/command_line.h>
#include <voussoir/run/worker.h>
#include <voussoir/terminal/interruption.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/multithread_info.h>

#include <csignal>
#include <exception>
#include <future>
#include <iostream>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <vector>

namespace
{
/** As under nohup. */
bool hang_ups_are_ignored = false;

/**
 * Before the libraries, since Debian 13's Ipopt begins MPI when it is loaded,
 * which forgets that a signal is ignored.
 */
[[maybe_unused]] void before_libraries()
{
  struct sigaction action;
  hang_ups_are_ignored =
      sigaction(SIGHUP, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
  Voussoir::expect_mpi();
}

#ifndef __SANITIZE_ADDRESS__ // which has to be ready first
[[gnu::section(".preinit_array"),
  gnu::used]] void (*const first)() = before_libraries;
#endif

/**
 * Where the system refuses threads this one does all, which TBB would not do by
 * itself.
 */
void look_for_threads()
{
  std::vector<std::thread> threads;
  std::promise<void> all;
  const std::shared_future<void> are_there = all.get_future().share();
  try
  {
    while (threads.size() + 1 < dealii::MultithreadInfo::n_threads())
      threads.emplace_back([are_there] { are_there.wait(); });
  }
  catch (const std::system_error &)
  {
    dealii::MultithreadInfo::set_thread_limit(1);
  }
  all.set_value(); // no one's place is another's
  for (std::thread &thread : threads)
    thread.join();
}

int run(const int argc, char **argv)
{
  if (hang_ups_are_ignored)
    std::signal(SIGHUP, SIG_IGN);
  Voussoir::keep_memory();
  dealii::deal_II_exceptions::suppress_stacktrace_in_exceptions();
  Voussoir::trap_invalid_operations();
  Voussoir::Interruption interruption;
  Voussoir::Screens screens;
  Voussoir::ProcessGroup processes;
  if (Voussoir::started_by_mpirun())
  {
    Voussoir::begin_mpi();
    Voussoir::share_cores();
    processes = Voussoir::ProcessGroup(MPI_COMM_WORLD);
    interruption.listen();
  }
  else
    screens = {Voussoir::screen_behind(STDOUT_FILENO),
               Voussoir::screen_behind(STDERR_FILENO)};
  look_for_threads();
  Voussoir::prepare_blas();
  // Results are written also if nobody reads what is said of them. (MPI sets
  // this signal back.)
  std::signal(SIGPIPE, SIG_IGN);
  int status = 0;
  if (processes.is_root())
  {
    if (screens.out.overwrites)
      interruption.clear_screen();
    status = Voussoir::run_command_line({argv + 1, argv + argc}, std::cout,
                                        std::cerr, processes, screens);
    processes.call("");
  }
  else
  {
    interruption.be_quiet();
    Voussoir::run_worker(processes);
  }
  status = processes.max(status);
  std::cout << std::flush;
  interruption.is_over(status);
  return status;
}
} // namespace

int main(int argc, char **argv)
{
  try
  {
    return run(argc, argv);
  }
  catch (const std::exception &error)
  {
    std::cerr << "voussoir: The program cannot begin: " << error.what()
              << std::endl;
    constexpr int no_answer = 4;
    return no_answer;
  }
}
