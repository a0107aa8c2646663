// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/packing/area_moments.h>

namespace Voussoir
{
using dealii::Tensor;

AreaMoments area_moments(const Packing<2> &packing, const unsigned int cell)
{
  AreaMoments of = {packing.area(cell), {}, {}};
  const dealii::Point<2> &centre = packing.centre(cell);
  for (unsigned int i = 0; i < packing.n_sides(cell); ++i)
  {
    const Tensor<1, 2> a = packing.vertex(cell, i) - centre;
    const Tensor<1, 2> b = packing.vertex(cell, i + 1) - centre;
    of.first += cross(a, b) / 6. * (a + b);
    for (const Tensor<1, 2> &x : {a, b, a + b})
      of.second += cross(a, b) / 24. * outer_product(x, x);
  }
  return of;
}
} // namespace Voussoir
