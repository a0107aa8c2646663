// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_chunks_h
#define voussoir_base_chunks_h

#include <voussoir/base/floating_point.h>

#include <deal.II/base/parallel.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <vector>

namespace Voussoir
{
/**
 * The number of items of a chunk: enough that the start of a task does not
 * count, and few enough that all cores have work in small packings.
 */
constexpr unsigned int items_of_a_chunk = 128;
/** The same of items that take a few operations each. */
constexpr unsigned int light_items_of_a_chunk = 1024;

/** The number of ranges of at most @p size that @p n items make. */
inline std::size_t n_chunks(const std::size_t n, const std::size_t size)
{
  return (n + size - 1) / size;
}

/**
 * Work was left undone, since other work beside it has thrown an exception.
 * That is the one which all of it ends with, and this is never seen outside.
 */
class WorkCancelled : public std::exception
{
};

/**
 * Call a function for consecutive ranges of numbers by all cores, with traps of
 * invalid operations as in the thread that calls this.
 *
 * If a call throws, others around it are left out, also of a for_chunks() that
 * one beside it is in: TBB would return from that without a word.
 *
 * @param n the end of the last range; the first begins at 0.
 * @param size the size of the ranges, and at most that of the last.
 * @param function takes the number of a range, its begin and its end.
 */
template <typename Function>
void for_chunks(const std::size_t n,
                const std::size_t size,
                const Function &function)
{
  const std::size_t n_ranges = n_chunks(n, size);
  const auto call = [&](const std::size_t begin, const std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      function(k, k * size, std::min(n, (k + 1) * size));
  };
  if (n_ranges <= 1)
  {
    call(0, n_ranges);
    return;
  }
  const bool are_trapped = invalid_operations_are_trapped();
  std::atomic<std::size_t> n_done = 0;
  dealii::parallel::apply_to_subranges(
      std::size_t(0), n_ranges,
      [&](const std::size_t begin, const std::size_t end) {
        const InvalidOperationsTrapped as_there(are_trapped);
        call(begin, end);
        n_done += end - begin;
      },
      1);
  if (n_done < n_ranges)
    throw WorkCancelled();
}

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
  std::vector<Result> results(n_chunks(n, items_of_a_chunk));
  for_chunks(
      n, items_of_a_chunk,
      [&](const std::size_t k, const unsigned int begin,
          const unsigned int end) { results[k] = function(begin, end); });
  return results;
}
} // namespace Voussoir

#endif
