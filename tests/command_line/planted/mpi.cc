// SPDX-License-Identifier: LGPL-2.1-or-later
/*
 * MPI: error, what a call returns where errors are returned; and of a sum nan
 * and wrong.
 */
#include "plant.h"
#include <mpi.h>

extern "C" {
int MPI_Init_thread(int *argc, char ***argv, int required, int *provided)
{
  static Plant::Function function("MPI_Init_thread");
  static auto *const real =
      Plant::hidden<decltype(MPI_Init_thread)>("MPI_Init_thread");
  return Plant::is(function.call(), "error")
             ? MPI_ERR_OTHER
             : real(argc, argv, required, provided);
}

int MPI_Allreduce(const void *sent,
                  void *received,
                  int n,
                  MPI_Datatype type,
                  MPI_Op operation,
                  MPI_Comm communicator)
{
  static Plant::Function function("MPI_Allreduce");
  static auto *const real =
      Plant::hidden<decltype(MPI_Allreduce)>("MPI_Allreduce");
  const char *const failure = function.call();
  const int status = real(sent, received, n, type, operation, communicator);
  if (failure != nullptr && type == MPI_DOUBLE)
    Plant::spoil(failure, static_cast<double *>(received), n);
  return Plant::is(failure, "error") ? MPI_ERR_OTHER : status;
}

int MPI_Recv(void *buffer,
             int n,
             MPI_Datatype type,
             int source,
             int tag,
             MPI_Comm communicator,
             MPI_Status *status)
{
  static Plant::Function function("MPI_Recv");
  static auto *const real = Plant::hidden<decltype(MPI_Recv)>("MPI_Recv");
  const char *const failure = function.call();
  const int returned = real(buffer, n, type, source, tag, communicator, status);
  if (failure != nullptr && type == MPI_BYTE && n % sizeof(double) == 0)
    Plant::spoil(failure, static_cast<double *>(buffer), n / sizeof(double));
  return Plant::is(failure, "error") ? MPI_ERR_OTHER : returned;
}
}
