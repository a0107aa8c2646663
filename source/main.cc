// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/assist.h>
#include <voussoir/base/blas.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/memory.h>
#include <voussoir/command_line.h>
#include <voussoir/parallel/begin_mpi.h>
#include <voussoir/terminal/interruption.h>

#include <csignal>
#include <iostream>
#include <unistd.h>

int main(int argc, char **argv)
{
  Voussoir::keep_memory();
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
