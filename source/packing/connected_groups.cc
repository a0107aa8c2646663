// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/lowest_in_sets.h>
#include <voussoir/packing/connected_groups.h>

namespace Voussoir
{
template <int dim>
std::vector<unsigned int> connected_groups(
    const Packing<dim> &packing,
    const Ground ground,
    const std::vector<std::pair<unsigned int, unsigned int>> &others)
{
  const unsigned int n = packing.n_cells() + 1;
  boost::disjoint_sets_with_storage<> sets(n);
  const auto connect = [&](const unsigned int one, const unsigned int other) {
    if (ground == Ground::connects || other != packing.ground())
      sets.union_set(one, other);
  };
  for (const typename Packing<dim>::Interface &interface : packing.interfaces())
    connect(interface.cell_minus, interface.cell_plus);
  for (const auto &[one, other] : others)
    connect(one, other);
  return lowest_in_sets(sets, n);
}

unsigned int static_indeterminacy(const Packing<2> &packing,
                                  const std::vector<unsigned int> &group,
                                  const unsigned int n_per_cell,
                                  const unsigned int n_links)
{
  unsigned int n_free_groups = 0;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    n_free_groups += (group[c] == c && group[c] != group[packing.ground()]);
  return n_per_cell *
             (packing.interfaces().size() + n_free_groups - packing.n_cells()) +
         n_links;
}

template std::vector<unsigned int>
connected_groups(const Packing<2> &,
                 Ground,
                 const std::vector<std::pair<unsigned int, unsigned int>> &);
template std::vector<unsigned int>
connected_groups(const Packing<3> &,
                 Ground,
                 const std::vector<std::pair<unsigned int, unsigned int>> &);
} // namespace Voussoir
