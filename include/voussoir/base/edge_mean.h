// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_edge_mean_h
#define voussoir_base_edge_mean_h

#include <deal.II/base/point.h>

#include <functional>
#include <string>

namespace Voussoir
{
/**
 * The mean of @p f over the straight edge from @p a to @p b.
 *
 * It is exact to rounding for polynomials of degree five, and by halving the
 * parts that contribute most to the error also for functions with jumps, such
 * as a load on a part of an edge.
 *
 * @param a,b the ends; lengths.
 * @param f the function of the place, of any unit.
 * @param parameter where the function comes from, for the message.
 * @return the mean, in the unit of @p f.
 * @throws InputError if the function varies too fast for that.
 */
double edge_mean(const dealii::Point<2> &a,
                 const dealii::Point<2> &b,
                 const std::function<double(const dealii::Point<2> &)> &f,
                 const std::string &parameter);
} // namespace Voussoir

#endif
