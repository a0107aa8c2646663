// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/assist.h>
#include <voussoir/base/blas.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/command_line.h>
#include <voussoir/terminal/interruption.h>

#include <deal.II/base/mpi.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
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

int main(int argc, char **argv)
{
  using namespace dealii;
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
