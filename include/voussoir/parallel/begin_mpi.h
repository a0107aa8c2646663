// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_parallel_begin_mpi_h
#define voussoir_parallel_begin_mpi_h

namespace Voussoir
{
/**
 * True if a launcher of MPI started the program, which may give it a terminal
 * whatever its own output is (Open MPI; others by PMI or PMIx). To be asked
 * before MPI begins, which sets these variables itself.
 */
bool started_by_mpirun();

/**
 * Tell an MPI that is to begin, if no launcher started the program, that there
 * is no other process. Open MPI then starts none beside the program and looks
 * for no network, which would take as long as all the rest of a small run. All
 * programs that are alone would share one directory for their session, which
 * one may remove while another begins: there is none. What the user has set
 * stays.
 */
void expect_mpi();

/**
 * Begin MPI unless others have, until the program ends. One process alone needs
 * it for Trilinos and for Ipopt's MUMPS only, and would wait for it longer than
 * for a small solve. Signals stay with those that handle them.
 *
 * deal.II's MPI_InitFinalize, which must be the first to begin it, serves only
 * where Ipopt does not: Debian 13's begins MPI when it is loaded.
 */
void begin_mpi();

/** Have the processes on a machine share its cores as threads. */
void share_cores();
} // namespace Voussoir

#endif
