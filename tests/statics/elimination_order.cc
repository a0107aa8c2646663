// SPDX-License-Identifier: LGPL-2.1-or-later

// An order of elimination has each body once, and those that are to be last at
// its end. Where nested dissection is tried, because the many unknowns of a
// body make the factors expensive, these do not have more entries for that, and
// fewer if a side of the grid is last. Entries are counted here by the sets of
// rows of each column.

#include <voussoir/algebra/linear/elimination_order.h>

#include "tests.h"
#include <cholmod.h>
#include <iterator>

namespace test_elimination_order
{
using namespace Voussoir;

/** The bodies of a square grid touch those beside and at their corners. */
constexpr int n_of_side = 200, n_bodies = n_of_side * n_of_side;

/** The later neighbours of each body, ascending. */
std::vector<std::vector<int>> later_neighbours()
{
  std::vector<std::vector<int>> later(n_bodies);
  for (int b = 0; b < n_bodies; ++b)
    for (int y = b / n_of_side; y <= b / n_of_side + 1; ++y)
      for (int x = b % n_of_side - 1; x <= b % n_of_side + 1; ++x)
        if (x >= 0 && x < n_of_side && y < n_of_side && x + n_of_side * y > b)
          later[b].push_back(x + n_of_side * y);
  return later;
}

cholmod_sparse *graph_of(const std::vector<std::vector<int>> &later,
                         cholmod_common &common)
{
  std::size_t n_entries = 0;
  for (const auto &of_body : later)
    n_entries += of_body.size();
  cholmod_sparse *graph = cholmod_allocate_sparse(
      n_bodies, n_bodies, n_entries, true, true, -1, CHOLMOD_PATTERN, &common);
  int *first = static_cast<int *>(graph->p);
  int *row = static_cast<int *>(graph->i);
  for (int b = 0, k = 0; b < n_bodies; ++b)
  {
    for (const int neighbour : later[b])
      row[k++] = neighbour;
    first[b + 1] = k;
  }
  return graph;
}

/** Below the diagonal, with one unknown for each body. */
std::size_t n_entries_of_factors(const std::vector<std::vector<int>> &later,
                                 const std::vector<int> &order)
{
  std::vector<int> place(n_bodies);
  for (int k = 0; k < n_bodies; ++k)
    place[order[k]] = k;
  std::vector<std::vector<int>> rows(n_bodies);
  for (int b = 0; b < n_bodies; ++b)
    for (const int neighbour : later[b])
    {
      const auto [low, high] = std::minmax(place[b], place[neighbour]);
      rows[low].push_back(high);
    }
  std::size_t n = 0;
  for (std::vector<int> &column : rows)
  {
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
    n += column.size();
    // Those that are left couple, which the first of them remembers.
    if (!column.empty())
      std::copy(column.begin() + 1, column.end(),
                std::back_inserter(rows[column.front()]));
    column.clear();
  }
  return n;
}

void run()
{
  const std::vector<std::vector<int>> later = later_neighbours();
  cholmod_common common;
  cholmod_start(&common);
  cholmod_sparse *graph = graph_of(later, common);
  std::vector<unsigned int> side;
  for (unsigned int k = 0; k < n_of_side; ++k)
    side.push_back(k * n_of_side);

  for (const auto &last : {std::vector<unsigned int>(), side})
  {
    std::cout << last.size() << " bodies are last" << std::endl;
    std::vector<std::size_t> n_entries;
    for (const unsigned int n_unknowns : {1, 1000})
    {
      const std::vector<int> order =
          elimination_order(*graph, n_unknowns, last, common);
      std::vector<int> sorted = order;
      std::sort(sorted.begin(), sorted.end());
      bool once = sorted.size() == n_bodies;
      for (int b = 0; once && b < n_bodies; ++b)
        once = sorted[b] == b;
      check("each body once", once);
      std::vector<unsigned int> end(order.end() - last.size(), order.end());
      std::sort(end.begin(), end.end());
      check("the last at the end", end == last);
      n_entries.push_back(n_entries_of_factors(later, order));
    }
    check("not more entries by dissection", n_entries[1] <= n_entries[0]);
    if (!last.empty())
      check("fewer entries by dissection", n_entries[1] < n_entries[0]);
  }
  cholmod_free_sparse(&graph, &common);
  cholmod_finish(&common);
  check("nothing is left allocated", common.malloc_count == 0);
}

const RoomTest test("elimination_order", run);
} // namespace test_elimination_order
