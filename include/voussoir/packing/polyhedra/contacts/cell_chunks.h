// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_contacts_cell_chunks_h
#define voussoir_packing_polyhedra_contacts_cell_chunks_h

#include <deal.II/base/parallel.h>

#include <algorithm>
#include <vector>

namespace Voussoir
{
/**
 * The number of items of a chunk: enough that the start of a task does not
 * count, and few enough that all cores have work in small packings.
 */
constexpr unsigned int items_of_a_chunk = 128;

/**
 * What a function of a range of numbers makes of consecutive ranges, in their
 * order, by all cores. It does not depend on the number of cores.
 *
 * @param n the end of the last range; the first begins at 0.
 * @param function takes the begin and the end of a range.
 */
template <typename Function>
auto in_chunks(const unsigned int n, const Function &function)
{
  using Result = decltype(function(0U, 0U));
  const unsigned int size = items_of_a_chunk;
  const unsigned int n_chunks = n / size + (n % size > 0 ? 1 : 0);
  std::vector<Result> results(n_chunks);
  dealii::parallel::apply_to_subranges(
      0U, n_chunks,
      [&](const unsigned int begin, const unsigned int end) {
        for (unsigned int k = begin; k < end; ++k)
          results[k] = function(k * size, std::min(n, (k + 1) * size));
      },
      1);
  return results;
}
} // namespace Voussoir

#endif
