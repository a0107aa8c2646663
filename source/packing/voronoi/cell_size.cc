// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/voronoi/cell_size.h>

#include <cmath>

namespace Voussoir
{
double CellSize::operator()(const dealii::Point<2> &p) const
{
  const double size = expression({p[0], p[1]});
  if (!std::isfinite(size) || size <= 0.)
    throw InputError("The parameter '" + parameter + "', '" + formula +
                     "', is " + text_of_number(size) + " at " +
                     text_of_point(p) +
                     "; it must be positive and finite all over the packing.");
  return size;
}

void CellSize::refuse_as_too_small(const dealii::Point<2> &p) const
{
  throw InputError("The parameter '" + parameter + "', '" + formula +
                   "', comes too near to zero, or changes too fast, near " +
                   text_of_point(p) +
                   "; keep it away from zero, as by max(..., 0.01).");
}
} // namespace Voussoir
