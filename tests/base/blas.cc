// SPDX-License-Identifier: LGPL-2.1-or-later

// The kernel of OpenBLAS that is advised: only of Prescott's, and never against
// the user's choice.

#include <voussoir/base/blas.h>
#include <voussoir/output/summary/kernel_summary.h>

#include "tests.h"
#include <cstdlib>
#include <sstream>

namespace test_blas
{
using namespace Voussoir;

std::string advice(const unsigned int n_cells)
{
  std::ostringstream out;
  Terminal terminal(out);
  show_faster_kernel(terminal, n_cells);
  return out.str();
}

void run()
{
  const char *const before = std::getenv("OPENBLAS_CORETYPE");
  const std::string chosen = before == nullptr ? "" : before;
  unsetenv("OPENBLAS_CORETYPE");
  const std::string faster = faster_blas_kernel();
  check("a kernel beyond Prescott's, or none",
        faster.empty() || (blas_kernel() == "Prescott" &&
                           (faster == "SkylakeX" || faster == "Haswell")));
  check("it is said of large packings",
        (advice(1000000).find("OPENBLAS_CORETYPE=" + faster) !=
         std::string::npos) == !faster.empty());
  check("not of others", advice(1000).empty());
  setenv("OPENBLAS_CORETYPE", "Prescott", 1);
  check("nor against a choice",
        faster_blas_kernel().empty() && advice(1000000).empty());
  if (before == nullptr)
    unsetenv("OPENBLAS_CORETYPE");
  else
    setenv("OPENBLAS_CORETYPE", chosen.c_str(), 1);
}

const RoomTest test("blas", run);
} // namespace test_blas
