// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/assist.h>
#include <voussoir/base/blas.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/command_line.h>
#include <voussoir/terminal/interruption.h>

#include <deal.II/base/mpi.h>

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

/**
 * True if a launcher of MPI started the program, which may give it a terminal
 * whatever its own output is (Open MPI; others by PMI or PMIx).
 */
bool started_by_mpirun()
{
  for (const char *name : {"OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMIX_RANK"})
    if (std::getenv(name) != nullptr)
      return true;
  return false;
}

/**
 * Let MPI begin quickly in a program that is alone: Open MPI then starts no
 * process beside it and looks for no network, which would take as long as all
 * the rest of a small run. All programs that are alone would share one
 * directory for their session, which one may remove while another begins: there
 * is none. What the user has set stays.
 */
void expect_no_other_process()
{
  constexpr bool overwrite = false;
  setenv("OMPI_MCA_ess_singleton_isolated", "1", overwrite);
  setenv("OMPI_MCA_orte_create_session_dirs", "0", overwrite);
  setenv("OMPI_MCA_pml", "ob1", overwrite);
  setenv("OMPI_MCA_btl", "self", overwrite);
}

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
  using namespace dealii;
  keep_memory();
  Voussoir::trap_invalid_operations();
  Voussoir::Interruption interruption;
  Voussoir::Screens screens;
  if (!started_by_mpirun()) // asked before MPI sets these variables itself
  {
    screens = {Voussoir::screen_behind(STDOUT_FILENO),
               Voussoir::screen_behind(STDERR_FILENO)};
    expect_no_other_process();
  }
  // Trilinos needs MPI even on one process.
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv);
  Voussoir::prepare_blas();
  interruption.listen();
  // Results are written also if nobody reads what is said of them. (MPI sets
  // this signal back.)
  std::signal(SIGPIPE, SIG_IGN);
  const Voussoir::Team team(MPI_COMM_WORLD);
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
