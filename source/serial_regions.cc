// SPDX-License-Identifier: LGPL-2.1-or-later

// A part of programs, not of the library: it replaces a function of GCC's
// OpenMP in all libraries of the program.

/**
 * A parallel region of OpenMP: the thread that meets it runs all of it.
 *
 * CHOLMOD asks for four threads in each of its small loops. GCC's library asks
 * the kernel to wake them at the end of each, even if there is only the one,
 * which takes up to half of the time of a factorisation (measured, 10,000 to
 * 1,000,000 cells). Threads and processes are the program's own.
 */
extern "C" __attribute__((visibility("default"))) void
GOMP_parallel(void (*region)(void *),
              void *data,
              unsigned int /*n_threads*/,
              unsigned int /*flags*/)
{
  region(data);
}
