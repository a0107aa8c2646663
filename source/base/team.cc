// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/team.h>

#include <deal.II/base/exceptions.h>

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

/** How long to sleep between two looks whether the root has called. */
constexpr auto nap = std::chrono::milliseconds(1);
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

void Team::call(const Task task) const
{
  if (n_processes == 1)
    return;
  int number = static_cast<int>(task);
  MPI_Request request;
  MPI_Ibcast(&number, 1, MPI_INT, 0, processes, &request);
  MPI_Wait(&request, MPI_STATUS_IGNORE);
}

Team::Task Team::wait() const
{
  int number = 0, has_come = 0;
  MPI_Request request;
  MPI_Ibcast(&number, 1, MPI_INT, 0, processes, &request);
  // MPI_Wait() would keep a core busy that the root can use.
  while (MPI_Test(&request, &has_come, MPI_STATUS_IGNORE), !has_come)
    std::this_thread::sleep_for(nap);
  return static_cast<Task>(number);
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
