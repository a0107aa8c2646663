// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_lowest_in_sets_h
#define voussoir_base_lowest_in_sets_h

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <vector>

namespace Voussoir
{
/** For each of @p n elements in disjoint @p sets the lowest one of its set. */
inline std::vector<unsigned int>
lowest_in_sets(boost::disjoint_sets_with_storage<> &sets, const unsigned int n)
{
  std::vector<unsigned int> lowest(n, n), result(n);
  for (unsigned int k = 0; k < n; ++k)
  {
    unsigned int &first = lowest[sets.find_set(k)];
    result[k] = first = std::min(first, k);
  }
  return result;
}
} // namespace Voussoir

#endif
