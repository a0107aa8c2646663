// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/parallel/begin_mpi.h>

#include <deal.II/base/multithread_info.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <mpi.h>
#include <mutex>

namespace Voussoir
{
namespace
{
/** Gives the program's handlers of signals back, which MPI replaces. */
class SignalsKept
{
public:
  SignalsKept()
  {
    for (std::size_t i = 0; i < handlers.size(); ++i)
      sigaction(i + 1, nullptr, &handlers[i]);
  }
  SignalsKept(const SignalsKept &) = delete;
  ~SignalsKept()
  {
    for (std::size_t i = 0; i < handlers.size(); ++i)
      sigaction(i + 1, &handlers[i], nullptr);
  }

private:
  std::array<struct sigaction, 31> handlers = {};
};

void end_mpi()
{
  int has_ended = 0;
  MPI_Finalized(&has_ended);
  if (!has_ended)
    MPI_Finalize();
}
} // namespace

bool started_by_mpirun()
{
  for (const char *name : {"OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMIX_RANK"})
    if (std::getenv(name) != nullptr)
      return true;
  return false;
}

void expect_mpi()
{
  if (started_by_mpirun())
    return;
  constexpr bool overwrite = false;
  setenv("OMPI_MCA_ess_singleton_isolated", "1", overwrite);
  setenv("OMPI_MCA_orte_create_session_dirs", "0", overwrite);
  setenv("OMPI_MCA_pml", "ob1", overwrite);
  setenv("OMPI_MCA_btl", "self", overwrite);
}

void begin_mpi()
{
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  int has_begun = 0;
  MPI_Initialized(&has_begun);
  if (has_begun)
    return;
  expect_mpi();
  const SignalsKept kept;
  int provided;
  if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided) !=
      MPI_SUCCESS)
    throw SolverError("MPI, which Ipopt and multigrid need, cannot begin. Set "
                      "'Formulation = least energy', with its 'Linear solver = "
                      "direct'.");
  std::atexit(end_mpi);
}

void share_cores()
{
  MPI_Comm machine;
  int n_processes, rank;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL,
                      &machine);
  MPI_Comm_size(machine, &n_processes);
  MPI_Comm_rank(machine, &rank);
  MPI_Comm_free(&machine);
  const unsigned int n_cores = dealii::MultithreadInfo::n_cores();
  const unsigned int n_own =
      n_cores / n_processes +
      (static_cast<unsigned int>(rank) < n_cores % n_processes ? 1 : 0);
  dealii::MultithreadInfo::set_thread_limit(std::max(n_own, 1U));
}
} // namespace Voussoir
