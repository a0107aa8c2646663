// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/elimination_order.h>

#include <cholmod.h>
#include <new>

namespace Voussoir
{
namespace
{
/**
 * The operations for each entry of the factors, and the entries of the factors
 * for each of the matrix, from which nested dissection is tried; CHOLMOD's.
 */
constexpr double operations_for_dissection = 500., fill_for_dissection = 5.;

/** An order that does not constrain, and the number of entries it leads to. */
struct Order
{
  std::vector<int> bodies;
  double n_entries;
};

Order find(cholmod_sparse &graph, const int method, cholmod_common &common)
{
  common.nmethods = 1;
  common.method[0].ordering = method;
  common.postorder = true;
  common.supernodal = CHOLMOD_SIMPLICIAL; // the cheaper analysis
  cholmod_factor *factor = cholmod_analyze(&graph, &common);
  if (factor == nullptr)
    throw std::bad_alloc();
  const int *order = static_cast<const int *>(factor->Perm);
  Order result = {{order, order + factor->n}, common.lnz};
  cholmod_free_factor(&factor, &common);
  return result;
}
} // namespace

std::vector<int> elimination_order(cholmod_sparse &graph,
                                   const unsigned int n_unknowns,
                                   const std::vector<unsigned int> &last,
                                   cholmod_common &common)
{
  if (!last.empty())
  {
    std::vector<int> set(graph.nrow, 0), order(graph.nrow);
    for (const unsigned int body : last)
      set[body] = 1;
    if (!cholmod_camd(&graph, nullptr, 0, set.data(), order.data(), &common))
      throw std::bad_alloc();
    return order;
  }
  const Order by_degree = find(graph, CHOLMOD_AMD, common);
  // Blocks of n unknowns have n^2 entries and cost n^3 operations.
  if (n_unknowns * common.fl < operations_for_dissection * common.lnz ||
      common.lnz < fill_for_dissection * common.anz)
    return by_degree.bodies;
  const Order by_dissection = find(graph, CHOLMOD_METIS, common);
  return by_dissection.n_entries < by_degree.n_entries ? by_dissection.bodies
                                                       : by_degree.bodies;
}
} // namespace Voussoir
