// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/packing/polygons/arc.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

double Arc::angle() const
{
  return 4. * std::atan(bulge);
}

double Arc::radius() const
{
  return 0.25 * start.distance(end) * (1. + bulge * bulge) / std::abs(bulge);
}

Point<2> Arc::centre() const
{
  const Tensor<1, 2> along = end - start;
  // Of a turn to the left it lies to the left of the chord, up to a half.
  return start + 0.5 * along +
         0.25 * (1. / bulge - bulge) * Tensor<1, 2>({-along[1], along[0]});
}

Point<2> Arc::at(const double turned) const
{
  // By half-angles from the start: flat arcs have a distant centre.
  const double half = 0.5 * angle();
  return start + std::sin(0.5 * turned) / std::sin(half) *
                     (rotation_by(0.5 * turned - half) * (end - start));
}

double Arc::angle_to(const Point<2> &p) const
{
  const Tensor<1, 2> from_start = start - centre(), to_p = p - centre();
  const double turned = std::atan2(cross(from_start, to_p), from_start * to_p);
  const double forward = bulge > 0. ? turned : -turned;
  return forward < 0. ? forward + 2. * dealii::numbers::PI : forward;
}

double bulge_through(const Point<2> &start,
                     const Point<2> &middle,
                     const Point<2> &end)
{
  // Half of the angle of the arc is what the chain of chords turns by.
  const Tensor<1, 2> first = middle - start, second = end - middle;
  return std::tan(0.5 * std::atan2(cross(first, second), first * second));
}
} // namespace Voussoir
