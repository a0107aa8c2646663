// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/generators/arch_joints.h>

#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>

#include <cmath>

namespace Voussoir
{
using dealii::Point;

HalfArch circular_arch(const std::string &section,
                       const double mean_radius,
                       const double thickness,
                       const unsigned int n_voussoirs,
                       const double embrace)
{
  if (!(thickness < 2. * mean_radius))
    throw InputError(text("The arch '", section, "' has the thickness ",
                          thickness, " and the mean radius ", mean_radius,
                          "; the thickness must be less than twice the "
                          "radius."));

  HalfArch half;
  const double inner = mean_radius - 0.5 * thickness;
  const double outer = mean_radius + 0.5 * thickness;
  for (unsigned int k = 0; 2 * k <= n_voussoirs; ++k)
  {
    // The angle from the vertical over pi, for functions that are exact where
    // the sine or the cosine vanishes.
    const double turn = embrace * (n_voussoirs - 2 * k) / (360. * n_voussoirs);
    const double x = 0. - boost::math::sin_pi(turn); // not -0
    const double y = boost::math::cos_pi(turn);
    half.joints.push_back({{inner * x, inner * y}, {outer * x, outer * y}});
  }
  return half;
}

namespace
{
/** One half of a pointed arch; lengths, and angles from its springing. */
struct Arc
{
  double half_span;
  /** Of the middle line. */
  double radius;
  /** Of the middle line's end at the crown. */
  double angle;

  /** The point at @p angle that is @p offset outside the middle line. */
  Point<2> point(const double angle, const double offset) const
  {
    // From the springing, not from the far centre of the arc.
    const double rise = std::sin(0.5 * angle);
    return {2. * (radius + offset) * rise * rise - half_span - offset,
            (radius + offset) * std::sin(angle)};
  }

  /** The point on x = 0 that is @p offset outside the middle line. */
  Point<2> crown(const double offset) const
  {
    // By Pythagoras from the centre of the arc, radius - half_span to the
    // right of x = 0.
    return {0., std::sqrt((half_span + offset) *
                          (2. * radius - half_span + offset))};
  }
};
} // namespace

HalfArch pointed_arch(const std::string &section,
                      const double span,
                      const double radius_over_span,
                      const double thickness,
                      const unsigned int n_voussoirs)
{
  if (!(thickness < span))
    throw InputError(text("The arch '", section, "' has the thickness ",
                          thickness, " and the span ", span,
                          "; the thickness must be less than the span of the "
                          "middle line, or no opening is left."));

  const Arc arc = {0.5 * span, radius_over_span * span,
                   2. * std::asin(std::sqrt(0.25 / radius_over_span))};
  const double offset = 0.5 * thickness;
  HalfArch half;
  double angle = 0.;
  for (unsigned int k = 0; 2 * k < n_voussoirs; ++k)
  {
    angle = arc.angle * 2 * k / n_voussoirs;
    half.joints.push_back(
        {arc.point(angle, -offset), arc.point(angle, offset)});
  }
  if (!(half.joints.back().intrados[0] < 0.))
  {
    const double centre = arc.radius - arc.half_span;
    throw InputError(text("The joints next to the crown of the arch '", section,
                          "' reach over it: with ", n_voussoirs,
                          " voussoirs the thickness must be less than ",
                          2. * (arc.radius - centre / std::cos(angle)),
                          " and is ", thickness,
                          "; reduce 'Thickness' or 'Voussoirs'."));
  }
  if (n_voussoirs % 2 == 0)
    half.joints.push_back({arc.crown(-offset), arc.crown(offset)});
  else
    half.apex = arc.crown(offset);
  return half;
}
} // namespace Voussoir
