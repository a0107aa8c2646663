// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/blas.h>
#include <voussoir/base/text.h>
#include <voussoir/output/summary/kernel_summary.h>

namespace Voussoir
{
namespace
{
/** From where on it counts (measured, 100,000 cells: a sixth of the time). */
constexpr unsigned int many_cells = 20000;
} // namespace

void show_faster_kernel(Terminal &terminal, const unsigned int n_cells)
{
  if (n_cells < many_cells)
    return;
  if (const std::string faster = faster_blas_kernel(); !faster.empty())
    terminal.stage("OpenBLAS",
                   text("takes the kernel ", blas_kernel(),
                        ", as it does not know this processor: set the "
                        "environment variable OPENBLAS_CORETYPE=",
                        faster, " for a faster one"));
}
} // namespace Voussoir
