// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/assist.h>
#include <voussoir/base/blas.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/command_line.h>
#include <voussoir/parallel/begin_mpi.h>
#include <voussoir/terminal/interruption.h>

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

/**
 * Let memory that is given back stay with the program, and come in large pages.
 * The vectors of a million cells come and go at each of Newton's steps; the
 * kernel, which would hand out each of them anew, empty and in pages of 4 kB,
 * takes a third of the time of statics for that.
 */
void keep_memory()
{
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
  // Addresses alone, which all later memory is taken from.
  const std::size_t page = sysconf(_SC_PAGESIZE);
  const std::size_t n_bytes = sysconf(_SC_PHYS_PAGES) / 2 * page;
  void *const begin = std::malloc(n_bytes);
  if (begin == nullptr)
    return;
  const auto address = reinterpret_cast<std::uintptr_t>(begin);
  const std::size_t to_page = page - address % page;
  madvise(static_cast<char *>(begin) + to_page, n_bytes - to_page,
          MADV_HUGEPAGE);
  std::free(begin);
#endif
}

int main(int argc, char **argv)
{
  keep_memory();
  Voussoir::trap_invalid_operations();
  Voussoir::Interruption interruption;
  Voussoir::Screens screens;
  Voussoir::Team team;
  if (Voussoir::started_by_mpirun())
  {
    Voussoir::begin_mpi();
    Voussoir::share_cores();
    team = Voussoir::Team(MPI_COMM_WORLD);
    interruption.listen();
  }
  else
    screens = {Voussoir::screen_behind(STDOUT_FILENO),
               Voussoir::screen_behind(STDERR_FILENO)};
  Voussoir::prepare_blas();
  // Results are written also if nobody reads what is said of them. (MPI sets
  // this signal back.)
  std::signal(SIGPIPE, SIG_IGN);
  int status = 0;
  if (team.is_root())
  {
    if (screens.out.overwrites)
      interruption.clear_screen();
    status = Voussoir::run_command_line({argv + 1, argv + argc}, std::cout,
                                        std::cerr, team, screens);
    team.call("");
  }
  else
  {
    interruption.be_quiet();
    Voussoir::assist(team);
  }
  return team.max(status);
}
