// SPDX-License-Identifier: LGPL-2.1-or-later

// The MPI of the process is the real one, although Ipopt brings stand-ins for
// it: every rank is seen, ranks exchange data, and Ipopt solves on each.

#include <voussoir/parallel/begin_mpi.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/multithread_info.h>

#include "tests.h"
#include <fstream>

using namespace Voussoir;

int main()
{
  begin_mpi();
  dealii::MultithreadInfo::set_thread_limit(1);
  const unsigned int rank =
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);

  const Scene scene = scene_under_stress(random_packing(50 + rank, 1), 0.5,
                                         tensor(-1.1, 0, 0, -0.9));
  const double residual =
      certify(scene, Solver(hard).forces(scene)).equilibrium_residual;
  const auto residuals =
      dealii::Utilities::MPI::gather(MPI_COMM_WORLD, residual);

  if (rank == 0)
  {
    // Into a file: the launcher may have something to say on the terminal.
    std::ofstream file("output");
    std::streambuf *const terminal = std::cout.rdbuf(file.rdbuf());
    std::cout << "ranks: " << residuals.size() << std::endl;
    for (unsigned int r = 0; r < residuals.size(); ++r)
      check_error("rank " + std::to_string(r) + ": Ipopt's residual",
                  residuals[r], 1e-9);
    std::cout.rdbuf(terminal);
  }
}
