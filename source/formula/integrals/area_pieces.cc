// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/formula/integrals/area_pieces.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Voussoir
{
using dealii::Point;
using Corners = std::vector<Point<2>>;
using Crossing = Discontinuities::Crossing;

namespace
{
/** The part of the area that is too small to be cut again. */
constexpr double smallest_piece = 1e-13;
/** The largest number of pieces. */
constexpr unsigned int n_max_area_pieces = 2000;

/** The distance of an argument from its level, over the size of what it is a
 * difference of, that is rounding. */
constexpr double rounding_of_area = 1e-14;
/** The slope of a linear argument, over the sizes of its terms, that is
 * rounding.
 */
constexpr double rounding_of_slope = 1e-12;

bool is_linear(const Crossing &crossing)
{
  const auto &slope = crossing.distance.slope;
  const double largest = magnitude(slope[0]) + magnitude(slope[1]);
  return std::isfinite(largest) && largest > 0. &&
         width(slope[0]) + width(slope[1]) <= rounding_of_slope * largest;
}

/** The distances at the corners, those that are rounding as zero. */
std::vector<double> distances(const Corners &corners,
                              const Discontinuities &jumps,
                              const Crossing &crossing)
{
  std::vector<double> distance;
  for (const Point<2> &corner : corners)
  {
    const double d = jumps.distance(crossing, corner);
    distance.push_back(std::abs(d) <= rounding_of_area * crossing.scale ? 0.
                                                                        : d);
  }
  return distance;
}

/** The part of a convex polygon where a linear function, given at its corners,
 * is not negative; empty or without area if there is none. */
Corners clip(const Corners &corners, const std::vector<double> &value)
{
  Corners part;
  for (unsigned int i = 0; i < corners.size(); ++i)
  {
    const unsigned int j = (i + 1) % corners.size();
    if (value[i] >= 0.)
      part.push_back(corners[i]);
    if (value[i] * value[j] < 0.)
      part.push_back(corners[i] + value[i] / (value[i] - value[j]) *
                                      (corners[j] - corners[i]));
  }
  return part;
}

struct AreaCutter
{
  const Discontinuities &jumps;
  const double area;
  std::vector<AreaPiece> open = {}, done = {};

  std::vector<AreaPiece> cut(const Corners &corners)
  {
    open.push_back({corners, {}, 0, jumps.no_limits(), false});
    while (!open.empty())
    {
      AreaPiece part = std::move(open.back());
      open.pop_back();
      cut(std::move(part));
    }
    return std::move(done);
  }

  void cut(AreaPiece part)
  {
    const Patch box = box_around(part.corners);
    const auto crossings = jumps.crossings(box, part.limits);
    if (crossings.empty())
      return done.push_back(std::move(part));
    const auto linear =
        std::find_if(crossings.begin(), crossings.end(), is_linear);
    if (linear != crossings.end())
      return cut_along_line(part, *linear);
    if (are_one_curve(crossings, part.corners))
      for (const unsigned int i : {0, 1})
        if (excludes_zero(crossings.front().distance.slope[i]))
        {
          part.crossing = crossings.front();
          part.along = i;
          return done.push_back(std::move(part));
        }
    if (signed_area(part.corners) <= smallest_piece * area ||
        open.size() + done.size() > n_max_area_pieces)
    {
      part.is_uncertain = true;
      return done.push_back(std::move(part));
    }
    cut_in_halves(part, box);
  }

  /** Add the part where a linear function is positive, if it has an area. */
  void add(const AreaPiece &whole,
           const std::vector<double> &value,
           const Discontinuities::Limits &limits)
  {
    Corners corners = clip(whole.corners, value);
    if (corners.size() > 2 && signed_area(corners) > 0.)
      open.push_back({std::move(corners), {}, 0, limits, false});
  }

  /** Add the parts on both sides of where a linear function is zero. */
  void add_both(const AreaPiece &whole,
                std::vector<double> value,
                const Discontinuities::Limits &limits_above,
                const Discontinuities::Limits &limits_below)
  {
    add(whole, value, limits_above);
    for (double &v : value)
      v *= -1.;
    add(whole, value, limits_below);
  }

  void cut_along_line(const AreaPiece &part, const Crossing &crossing)
  {
    add_both(part, distances(part.corners, jumps, crossing),
             Discontinuities::on_side(crossing, false, part.limits),
             Discontinuities::on_side(crossing, true, part.limits));
  }

  void cut_in_halves(const AreaPiece &part, const Patch &box)
  {
    const unsigned int i = box.half_axes[0][0] > box.half_axes[1][1] ? 0 : 1;
    std::vector<double> value;
    for (const Point<2> &corner : part.corners)
      value.push_back(corner[i] - box.centre[i]);
    add_both(part, std::move(value), part.limits, part.limits);
  }

  /** True if crossings are of the same curve, named more than once. */
  bool are_one_curve(const std::vector<Crossing> &crossings,
                     const Corners &corners) const
  {
    for (unsigned int k = 1; k < crossings.size(); ++k)
      for (const Point<2> &corner : corners)
        if (std::abs(jumps.distance(crossings[k], corner)) !=
            std::abs(jumps.distance(crossings[0], corner)))
          return false;
    return true;
  }
};
} // namespace

std::vector<AreaPiece> area_pieces(const Corners &corners,
                                   const Discontinuities &jumps)
{
  return AreaCutter{jumps, signed_area(corners)}.cut(corners);
}
} // namespace Voussoir
