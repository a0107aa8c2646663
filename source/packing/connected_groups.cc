// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/lowest_in_sets.h>
#include <voussoir/packing/connected_groups.h>

namespace Voussoir
{
template <int dim>
std::vector<unsigned int> connected_groups(const Packing<dim> &packing,
                                           const Ground ground)
{
  const unsigned int n = packing.n_cells() + 1;
  boost::disjoint_sets_with_storage<> sets(n);
  for (const typename Packing<dim>::Interface &interface : packing.interfaces())
    if (ground == Ground::connects || interface.cell_plus != packing.ground())
      sets.union_set(interface.cell_minus, interface.cell_plus);
  return lowest_in_sets(sets, n);
}

unsigned int static_indeterminacy(const Packing<2> &packing,
                                  const unsigned int n_per_cell)
{
  const std::vector<unsigned int> group = connected_groups(packing);
  unsigned int n_free_groups = 0;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    n_free_groups += (group[c] == c && group[c] != group[packing.ground()]);
  return n_per_cell *
         (packing.interfaces().size() + n_free_groups - packing.n_cells());
}

template std::vector<unsigned int> connected_groups(const Packing<2> &, Ground);
template std::vector<unsigned int> connected_groups(const Packing<3> &, Ground);
} // namespace Voussoir
