// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_parallel_process_group_h
#define voussoir_parallel_process_group_h

#include <voussoir/base/exceptions.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/mpi_large_count.h>

#include <exception>
#include <new>
#include <string>
#include <type_traits>
#include <vector>

namespace Voussoir
{
/**
 * The processes that work on one run. Process 0, the root, reads the input,
 * decides what is done and writes; the others wait until it calls() them to a
 * task, in which all take part.
 *
 * A group of one needs no MPI, which otherwise must give the same result of a
 * sum to all processes, bit by bit: what they do next depends on it. Functions
 * that are collective say so.
 */
class ProcessGroup
{
public:
  /** This process alone. */
  ProcessGroup() = default;
  /** The processes of @p communicator. */
  explicit ProcessGroup(MPI_Comm communicator)
      : mpi(communicator),
        n_processes(dealii::Utilities::MPI::n_mpi_processes(communicator)),
        own_rank(dealii::Utilities::MPI::this_mpi_process(communicator))
  {}

  /** The communicator of MPI; MPI_COMM_SELF for one process alone. */
  MPI_Comm communicator() const { return mpi; }
  /** The number of processes. */
  unsigned int size() const { return n_processes; }
  /** The number of this process, from 0 to size() - 1. */
  unsigned int rank() const { return own_rank; }
  /** True if this is process 0. */
  bool is_root() const { return own_rank == 0; }

  /**
   * On the root, collective with wait(): let the others return from it with the
   * name of a @p task, of up to 31 letters; none of them to end.
   */
  void call(const std::string &task) const;
  /** On the others: sleep until the root calls. */
  std::string wait() const;

  /**
   * End all processes with exit status 4; for an error that the others do not
   * know of and would wait for without end.
   */
  [[noreturn]] void abort(const std::string &message) const;

  /**
   * Take part in a task: do @p action, and abort() for an error other than a
   * SolverError, which all processes find together.
   */
  template <typename Action>
  auto together(const Action &action) const
  {
    try
    {
      return action();
    }
    catch (const SolverError &)
    {
      throw;
    }
    catch (const std::bad_alloc &)
    {
      if (n_processes > 1)
        abort("There is not enough memory for this packing.");
      throw;
    }
    catch (const std::exception &error)
    {
      if (n_processes > 1)
        abort(error.what());
      throw;
    }
    catch (...) // Trilinos throws numbers
    {
      if (n_processes > 1)
        abort("A library has failed.");
      throw;
    }
  }

  /** @{ */
  /** Over all processes, the same bits on each; collective. */
  template <typename T>
  T sum(const T value) const
  {
    return n_processes == 1 ? value : dealii::Utilities::MPI::sum(value, mpi);
  }

  template <typename T>
  T max(const T value) const
  {
    return n_processes == 1 ? value : dealii::Utilities::MPI::max(value, mpi);
  }

  template <typename T>
  T min(const T value) const
  {
    return n_processes == 1 ? value : dealii::Utilities::MPI::min(value, mpi);
  }
  /** @} */
  /** True if @p value is true on all processes; collective. */
  bool all(const bool value) const { return min(value ? 1 : 0) == 1; }

  /** The root's @p value, on all processes; plain data, collective. */
  template <typename T>
  T broadcast(const T &value) const
  {
    return n_processes == 1 ? value
                            : dealii::Utilities::MPI::broadcast(mpi, value);
  }

  /**
   * On the root the values of each process; nothing on the others. Collective.
   */
  template <typename T>
  std::vector<std::vector<T>> gather(const std::vector<T> &values) const
  {
    std::vector<std::vector<T>> gathered;
    if (!is_root())
      send(values, 0);
    else
    {
      gathered.push_back(values);
      for (unsigned int r = 1; r < n_processes; ++r)
        gathered.push_back(receive<T>(r));
    }
    return gathered;
  }

  /**
   * The values of the root for this process, element rank() of its @p values,
   * which are ignored on the others; collective.
   */
  template <typename T>
  std::vector<T> scatter(const std::vector<std::vector<T>> &values) const
  {
    if (!is_root())
      return receive<T>(0);
    for (unsigned int r = 1; r < n_processes; ++r)
      send(values[r], r);
    return values[0];
  }

  /** @{ */
  /**
   * From one process to another, which receives it; plain data. By deal.II for
   * messages of any length; MPI's own counts end at 2 GB.
   */
  template <typename T>
  void send(const std::vector<T> &values, const unsigned int to) const
  {
    static_assert(std::is_trivially_copyable<T>::value, "sent as bytes");
    dealii::Utilities::MPI::LargeCount::Send_c(
        values.data(), sizeof(T) * values.size(), MPI_BYTE, to, 0, mpi);
  }

  template <typename T>
  std::vector<T> receive(const unsigned int from) const
  {
    static_assert(std::is_trivially_copyable<T>::value, "sent as bytes");
    MPI_Status status;
    MPI_Count size = 0;
    MPI_Probe(from, 0, mpi, &status);
    MPI_Get_elements_x(&status, MPI_BYTE, &size);
    std::vector<T> values(size / sizeof(T));
    dealii::Utilities::MPI::LargeCount::Recv_c(values.data(), size, MPI_BYTE,
                                               from, 0, mpi, MPI_STATUS_IGNORE);
    return values;
  }
  /** @} */

private:
  MPI_Comm mpi = MPI_COMM_SELF;
  unsigned int n_processes = 1;
  unsigned int own_rank = 0;
};
} // namespace Voussoir

#endif
