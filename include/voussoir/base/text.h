// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_text_h
#define voussoir_base_text_h

#include <deal.II/base/point.h>

#include <cmath>
#include <sstream>
#include <string>

namespace Voussoir
{
/** All arguments written one after the other, numbers with six digits. */
template <typename... Arguments>
std::string text(const Arguments &...arguments)
{
  std::ostringstream out;
  out.precision(6);
  (out << ... << arguments);
  return out.str();
}

/** A number with @p n_digits digits at most. */
inline std::string text_with_digits(const double x, const int n_digits)
{
  std::ostringstream out;
  out.precision(n_digits);
  out << x;
  return out.str();
}

/** A number with digits enough to be copied, and to see what differs. */
inline std::string text_to_copy(const double x)
{
  return text_with_digits(x, 12);
}

/** A number that may be none: without the sign that a NaN may have. */
inline std::string text_of_number(const double x)
{
  return std::isnan(x) ? "not a number" : text(x);
}

/** A number of things, such as "1 support" or "2 supports". */
inline std::string counted(const std::size_t n, const std::string &things)
{
  return text(n, ' ', things, n == 1 ? "" : "s");
}

/**
 * A point as "(x, y)" or "(x, y, z)", with digits enough to find it in a
 * drawing.
 */
template <int dim = 2>
std::string text_of_point(const dealii::Point<dim> &p)
{
  std::ostringstream out;
  out.precision(9);
  for (unsigned int d = 0; d < dim; ++d) // abs: a NaN may have a sign
    out << (d == 0 ? "(" : ", ") << (std::isnan(p[d]) ? std::abs(p[d]) : p[d]);
  out << ')';
  return out.str();
}
} // namespace Voussoir

#endif
