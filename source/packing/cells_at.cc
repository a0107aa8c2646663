// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/packing/cells_at.h>

#include <deal.II/boost_adaptors/point.h>

#include <boost/geometry.hpp>

#include <cmath>
#include <limits>

namespace Voussoir
{
using dealii::Point;

namespace
{
/**
 * The distance of a place from a cell, over the root of its area, that counts
 * as none.
 */
constexpr double largest_distance_from_cell = 1e-6;

/** The distance of @p x from a cell, zero in it, over the root of its area. */
double relative_distance(const Packing<2> &packing,
                         const unsigned int c,
                         const Point<2> &x)
{
  boost::geometry::model::ring<Point<2>, false, false> ring;
  for (unsigned int i = 0; i < packing.n_sides(c); ++i)
    ring.push_back(packing.vertex(c, i));
  return boost::geometry::distance(x, ring) / std::sqrt(packing.area(c));
}
} // namespace

CellsAt::CellsAt(const Packing<2> &packing, const Point<2> &x)
{
  double least = std::numeric_limits<double>::infinity();
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    const double to_cell = relative_distance(packing, c, x);
    if (to_cell <= largest_distance_from_cell)
      there.push_back(c);
    if (to_cell < least)
    {
      least = to_cell;
      nearest = c;
    }
  }
  distance = least * std::sqrt(packing.area(nearest));
}

std::string CellsAt::describe_nearest(const Packing<2> &packing) const
{
  return text("the nearest is ", packing.describe(nearest), ", ",
              text_of_number(distance), " away");
}

bool is_in_cell(const Packing<2> &packing,
                const unsigned int cell,
                const Point<2> &x)
{
  return relative_distance(packing, cell, x) <= largest_distance_from_cell;
}
} // namespace Voussoir
