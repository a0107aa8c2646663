// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_vectors_h
#define voussoir_algebra_vectors_h

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Voussoir
{
/** The size of the largest component; zero of an empty vector. */
inline double largest_component(const std::vector<double> &v)
{
  double largest = 0.;
  for (const double component : v)
    largest = std::max(largest, std::abs(component));
  return largest;
}

/** The scalar product, summed with more digits. */
inline double dot(const std::vector<double> &a, const std::vector<double> &b)
{
  long double sum = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return static_cast<double>(sum);
}

/** Add @p factor times @p v to @p to. */
inline void
add(std::vector<double> &to, const double factor, const std::vector<double> &v)
{
  for (std::size_t i = 0; i < to.size(); ++i)
    to[i] += factor * v[i];
}
} // namespace Voussoir

#endif
