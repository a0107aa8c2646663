// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_blas_h
#define voussoir_base_blas_h

#include <string>

namespace Voussoir
{
/**
 * Make the machine's BLAS safe to call, where it is OpenBLAS.
 *
 * Threads and processes are the program's own, so that OpenBLAS gets one thread
 * a call; and if it is built for programs without threads
 * (libopenblas0-serial), which cannot be called by several at a time, the
 * program takes one thread, too. To be called after the start of deal.II, which
 * sets their number.
 */
void prepare_blas();

/**
 * The kernel of OpenBLAS for this processor, as "Haswell", on which the last
 * digits of results depend; empty of another BLAS.
 */
std::string blas_kernel();

/**
 * A faster kernel that this processor executes, for the environment's
 * OPENBLAS_CORETYPE, where OpenBLAS has taken that of Prescott, as for
 * processors younger than itself; empty elsewhere, and where the user has
 * chosen.
 */
std::string faster_blas_kernel();
} // namespace Voussoir

#endif
