// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/parallel/team.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <thread>

namespace Voussoir
{
namespace
{
/** The number of elements of a message, as MPI takes it. */
int count_of(const std::size_t count)
{
  AssertThrow(count <= std::size_t(std::numeric_limits<int>::max()),
              dealii::ExcMessage("A part of the packing is too large to send; "
                                 "use more processes."));
  return static_cast<int>(count);
}

/** Of a task, with the zero at its end. */
constexpr std::size_t length_of_names = 32;

/** The time that a worker sleeps between two polls for a call of the root. */
constexpr auto polling_interval = std::chrono::milliseconds(1);
} // namespace

/** An element of a message, so that long messages have counts that fit. */
class Team::Datatype
{
public:
  explicit Datatype(const std::size_t size)
  {
    MPI_Type_contiguous(static_cast<int>(size), MPI_BYTE, &type);
    MPI_Type_commit(&type);
  }

  ~Datatype()
  {
    MPI_Type_free(&type);
  }

  Datatype(const Datatype &) = delete;
  Datatype &operator=(const Datatype &) = delete;

  MPI_Datatype type;
};

Team::Team(MPI_Comm communicator)
    : processes(communicator),
      n_processes(dealii::Utilities::MPI::n_mpi_processes(communicator)),
      own_rank(dealii::Utilities::MPI::this_mpi_process(communicator))
{
}

MPI_Comm Team::communicator() const
{
  return processes;
}

unsigned int Team::size() const
{
  return n_processes;
}

unsigned int Team::rank() const
{
  return own_rank;
}

bool Team::is_root() const
{
  return own_rank == 0;
}

void Team::call(const std::string &task) const
{
  if (n_processes == 1)
    return;
  AssertThrow(task.size() < length_of_names, dealii::ExcInternalError());
  std::array<char, length_of_names> name = {};
  std::copy(task.begin(), task.end(), name.begin());
  MPI_Request request;
  MPI_Ibcast(name.data(), name.size(), MPI_CHAR, 0, processes, &request);
  MPI_Wait(&request, MPI_STATUS_IGNORE);
}

std::string Team::wait() const
{
  int has_come = 0;
  std::array<char, length_of_names> name = {};
  MPI_Request request;
  MPI_Ibcast(name.data(), name.size(), MPI_CHAR, 0, processes, &request);
  // MPI_Wait() would keep a core busy that the root can use.
  while (MPI_Test(&request, &has_come, MPI_STATUS_IGNORE), !has_come)
    std::this_thread::sleep_for(polling_interval);
  return name.data();
}

void Team::abort(const std::string &message) const
{
  std::cerr << "voussoir: process " << own_rank << ": " << message << std::endl;
  MPI_Abort(processes, 4);
  std::abort();
}

void Team::send(const void *data,
                const std::size_t size,
                const std::size_t count,
                const unsigned int to) const
{
  const Datatype element(size);
  MPI_Send(data, count_of(count), element.type, to, 0, processes);
}

std::size_t Team::size_of_message(const std::size_t size,
                                  const unsigned int from) const
{
  const Datatype element(size);
  MPI_Status status;
  int count = 0;
  MPI_Probe(from, 0, processes, &status);
  MPI_Get_count(&status, element.type, &count);
  return count;
}

void Team::receive(void *data,
                   const std::size_t size,
                   const std::size_t count,
                   const unsigned int from) const
{
  const Datatype element(size);
  MPI_Recv(data, count_of(count), element.type, from, 0, processes,
           MPI_STATUS_IGNORE);
}
} // namespace Voussoir
