// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/linear/cholmod_failure.h>
#include <voussoir/algebra/linear/elimination_order.h>

#include <algorithm>
#include <utility>

namespace Voussoir
{
namespace
{
/**
 * The operations for each entry of the factors, and the entries of the factors
 * for each of the matrix, from which nested dissection is tried; CHOLMOD's.
 */
constexpr double operations_for_dissection = 500., fill_for_dissection = 5.;

/** An order, and the number of entries that the factors have in it. */
struct Order
{
  std::vector<int> bodies;
  double n_entries;
};

/** @param given the order of CHOLMOD_GIVEN. */
Order find(cholmod_sparse &graph,
           const int method,
           cholmod_common &common,
           std::vector<int> given = {})
{
  common.nmethods = 1;
  common.method[0].ordering = method;
  common.postorder = method != CHOLMOD_GIVEN;
  common.supernodal = CHOLMOD_SIMPLICIAL; // the cheaper analysis
  cholmod_factor *factor = cholmod_analyze_p(
      &graph, given.empty() ? nullptr : given.data(), nullptr, 0, &common);
  check(factor, common);
  const int *order = static_cast<const int *>(factor->Perm);
  Order result = {{order, order + factor->n}, common.lnz};
  cholmod_free_factor(&factor, &common);
  return result;
}

/** Minimum degree, those that are last behind the others. */
Order constrained_by_degree(cholmod_sparse &graph,
                            const std::vector<bool> &is_last,
                            cholmod_common &common)
{
  std::vector<int> set(is_last.begin(), is_last.end()), order(set.size());
  if (!cholmod_camd(&graph, nullptr, 0, set.data(), order.data(), &common))
    throw_failure(common);
  return find(graph, CHOLMOD_GIVEN, common, std::move(order));
}

/**
 * Nested dissection of those that are not last, which are the first separator
 * of all.
 */
Order constrained_by_dissection(cholmod_sparse &graph,
                                const std::vector<bool> &is_last,
                                cholmod_common &common)
{
  cholmod_sparse *others = check(cholmod_copy_sparse(&graph, &common), common);
  int *first = static_cast<int *>(others->p);
  int *rows = static_cast<int *>(others->i);
  int n_entries = 0, begin = 0;
  for (std::size_t c = 0; c < others->ncol; ++c)
  {
    const int end = first[c + 1];
    for (int k = begin; k < end; ++k)
      if (!is_last[c] && !is_last[rows[k]])
        rows[n_entries++] = rows[k];
    first[c + 1] = n_entries;
    begin = end;
  }
  std::vector<int> order = find(*others, CHOLMOD_METIS, common).bodies;
  cholmod_free_sparse(&others, &common);
  std::stable_partition(order.begin(), order.end(),
                        [&](const int body) { return !is_last[body]; });
  return find(graph, CHOLMOD_GIVEN, common, std::move(order));
}
} // namespace

std::vector<int> elimination_order(cholmod_sparse &graph,
                                   const unsigned int n_unknowns,
                                   const std::vector<unsigned int> &last,
                                   cholmod_common &common)
{
  const bool is_constrained = !last.empty();
  std::vector<bool> is_last(graph.nrow, false);
  for (const unsigned int body : last)
    is_last[body] = true;
  const Order by_degree = is_constrained
                              ? constrained_by_degree(graph, is_last, common)
                              : find(graph, CHOLMOD_AMD, common);
  // Blocks of n unknowns have n^2 entries and cost n^3 operations.
  if (n_unknowns * common.fl < operations_for_dissection * common.lnz ||
      common.lnz < fill_for_dissection * common.anz)
    return by_degree.bodies;
  const Order by_dissection =
      is_constrained ? constrained_by_dissection(graph, is_last, common)
                     : find(graph, CHOLMOD_METIS, common);
  return by_dissection.n_entries < by_degree.n_entries ? by_dissection.bodies
                                                       : by_degree.bodies;
}
} // namespace Voussoir
