// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/floating_point.h>
#include <voussoir/base/interruption.h>
#include <voussoir/command_line.h>

#include <deal.II/base/mpi.h>

#include <iostream>

int main(int argc, char **argv)
{
  using namespace dealii;
  Voussoir::trap_invalid_operations();
  Voussoir::Interruption interruption;
  // Trilinos needs MPI even on one process. All the work is the root's.
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv);
  interruption.listen();
  int status = 0;
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    interruption.be_quiet();
  else
    status = Voussoir::run_command_line({argv + 1, argv + argc}, std::cout,
                                        std::cerr);
  return Utilities::MPI::max(status, MPI_COMM_WORLD);
}
