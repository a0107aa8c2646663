// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_cgal_result_h
#define voussoir_packing_cgal_result_h

#include <boost/variant.hpp>

#include <variant>

namespace Voussoir
{
/** @{ */
/**
 * What a result of CGAL is, such as that of CGAL::intersection(), if it is a T:
 * up to CGAL 5 a variant of Boost's.
 */
template <typename T, typename... Kinds>
const T *held(const std::variant<Kinds...> &result)
{
  return std::get_if<T>(&result);
}

template <typename T, typename... Kinds>
const T *held(const boost::variant<Kinds...> &result)
{
  return boost::get<T>(&result);
}
/** @} */

/** @{ */
/** What @p visitor gives for whatever such a result is. */
template <typename Visitor, typename... Kinds>
auto visit_result(const Visitor &visitor, const std::variant<Kinds...> &result)
{
  return std::visit(visitor, result);
}

template <typename Visitor, typename... Kinds>
auto visit_result(const Visitor &visitor,
                  const boost::variant<Kinds...> &result)
{
  return boost::apply_visitor(visitor, result);
}
/** @} */
} // namespace Voussoir

#endif
