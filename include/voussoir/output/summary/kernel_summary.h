// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_summary_kernel_summary_h
#define voussoir_output_summary_kernel_summary_h

#include <voussoir/terminal/terminal.h>

namespace Voussoir
{
/**
 * Show how to have a faster kernel of OpenBLAS, see faster_blas_kernel(), of
 * packings so large that it counts; nothing if there is none.
 */
void show_faster_kernel(Terminal &terminal, unsigned int n_cells);
} // namespace Voussoir

#endif
