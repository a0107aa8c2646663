// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/parallel/process_group.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <thread>

namespace Voussoir
{
namespace
{
/** Of a task, with the zero at its end. */
constexpr std::size_t length_of_names = 32;

/** The time that a worker sleeps between two polls for a call of the root. */
constexpr auto polling_interval = std::chrono::milliseconds(1);
} // namespace

void ProcessGroup::call(const std::string &task) const
{
  if (n_processes == 1)
    return;
  AssertThrow(task.size() < length_of_names, dealii::ExcInternalError());
  std::array<char, length_of_names> name = {};
  std::copy(task.begin(), task.end(), name.begin());
  MPI_Request request;
  MPI_Ibcast(name.data(), name.size(), MPI_CHAR, 0, mpi, &request);
  MPI_Wait(&request, MPI_STATUS_IGNORE);
}

std::string ProcessGroup::wait() const
{
  int has_come = 0;
  std::array<char, length_of_names> name = {};
  MPI_Request request;
  MPI_Ibcast(name.data(), name.size(), MPI_CHAR, 0, mpi, &request);
  // MPI_Wait() would keep a core busy that the root can use.
  while (MPI_Test(&request, &has_come, MPI_STATUS_IGNORE), !has_come)
    std::this_thread::sleep_for(polling_interval);
  return name.data();
}

void ProcessGroup::abort(const std::string &message) const
{
  std::cerr << "voussoir: process " << own_rank << ": " << message << std::endl;
  constexpr int no_answer = 4;
  MPI_Abort(mpi, no_answer);
  std::_Exit(no_answer);
}
} // namespace Voussoir
