// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_memory_h
#define voussoir_base_memory_h

namespace Voussoir
{
/**
 * Let memory that is given back stay with the program, and come in large pages;
 * to be called at its start. The vectors of a million cells come and go at each
 * of Newton's steps; the kernel, which would hand out each of them anew, empty
 * and in pages of 4 kB, takes a third of the time of statics for that. Without
 * glibc, and under AddressSanitizer, it does nothing.
 */
void keep_memory();
} // namespace Voussoir

#endif
