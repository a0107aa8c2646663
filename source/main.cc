// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/assist.h>
#include <voussoir/base/blas.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/interruption.h>
#include <voussoir/command_line.h>

#include <deal.II/base/mpi.h>

#include <iostream>
#include <unistd.h>

int main(int argc, char **argv)
{
  using namespace dealii;
  Voussoir::trap_invalid_operations();
  Voussoir::Interruption interruption;
  // Trilinos needs MPI even on one process.
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv);
  Voussoir::prepare_blas();
  interruption.listen();
  const Voussoir::Team team(MPI_COMM_WORLD);
  int status = 0;
  if (team.is_root())
  {
    const Voussoir::Screens screens = {Voussoir::screen_behind(STDOUT_FILENO),
                                       Voussoir::screen_behind(STDERR_FILENO)};
    status = Voussoir::run_command_line({argv + 1, argv + argc}, std::cout,
                                        std::cerr, team, screens);
    team.call(Voussoir::Team::Task::none);
  }
  else
  {
    interruption.be_quiet();
    Voussoir::assist(team);
  }
  return team.max(status);
}
