// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/generators/generator.h>

namespace Voussoir
{
/** The number with which a packing needs some 100 GB. */
constexpr double largest_number_of_cells = 1e8;

void check_number_of_cells(const double n_cells, const std::string &entries)
{
  if (n_cells > largest_number_of_cells)
    throw InputError(text(entries, " make some ", n_cells,
                          " cells; there may be ", largest_number_of_cells,
                          " at most."));
}
} // namespace Voussoir
