// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/floating_point.h>
#include <voussoir/formula/integrals/discontinuities.h>

#include <deal.II/base/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

/** The relative difference of two values that is no step. */
constexpr double rounding_of_values = 1e-9;

Patch box_around(const std::vector<Point<2>> &points)
{
  const auto [lower, upper] =
      dealii::BoundingBox<2>(points).get_boundary_points();
  Patch patch;
  patch.centre = lower + 0.5 * (upper - lower);
  for (unsigned int i = 0; i < 2; ++i)
    patch.half_axes[i][i] = 0.5 * (upper[i] - lower[i]);
  return patch;
}

Patch rectangle_around(const std::array<Point<2>, 3> &triangle)
{
  unsigned int longest = 0;
  double length = 0.;
  for (unsigned int i = 0; i < 3; ++i)
    if (triangle[i].distance(triangle[(i + 1) % 3]) > length)
    {
      longest = i;
      length = triangle[i].distance(triangle[(i + 1) % 3]);
    }
  const Tensor<1, 2> side = triangle[(longest + 1) % 3] - triangle[longest];
  const Tensor<1, 2> arm = triangle[(longest + 2) % 3] - triangle[longest];
  const Tensor<1, 2> height = arm - (arm * side) / (side * side) * side;
  return {triangle[longest] + 0.5 * (side + height),
          {{0.5 * side, 0.5 * height}}};
}

Discontinuities::Discontinuities(
    const std::vector<std::reference_wrapper<const Formula>> &formulas,
    const std::vector<double> &constants)
    : formulas(formulas)
{
  for (const Formula &formula : formulas)
    first.push_back(first.back() + formula.n_jumps());
  set_constants(constants);
}

void Discontinuities::set_constants(const std::vector<double> &constants)
{
  values.resize(2);
  values.insert(values.end(), constants.begin(), constants.end());
  bounds.assign(values.size(), {});
  for (unsigned int i = 2; i < values.size(); ++i)
    bounds[i].value = values[i];
}

std::vector<Bounds> Discontinuities::bounds_in(const Patch &patch,
                                               const Limits &limits) const
{
  const InvalidOperationsAllowed allowed;
  place(patch);
  return bounds_there(limits);
}

void Discontinuities::place(const Patch &patch) const
{
  for (unsigned int i = 0; i < 2; ++i)
  {
    const double s = patch.half_axes[0][i], t = patch.half_axes[1][i];
    const double reach = std::abs(s) + std::abs(t);
    values[i] = patch.centre[i];
    bounds[i] = {Interval(values[i] - reach, values[i] + reach), {{s, t}}};
  }
}

Discontinuities::Limits Discontinuities::limits_of(const unsigned int f,
                                                   const Limits &limits) const
{
  return Limits(limits.begin() + first[f], limits.begin() + first[f + 1]);
}

std::vector<Discontinuities::Crossing>
Discontinuities::crossings(const Patch &patch, const Limits &limits) const
{
  // Values that are not real are reported where they are evaluated, not here.
  const InvalidOperationsAllowed allowed;
  place(patch);
  std::vector<Crossing> crossings;
  for (unsigned int f = 0; f < formulas.size(); ++f)
  {
    const std::size_t begin = crossings.size();
    formulas[f].get().bounds(bounds, values, limits_of(f, limits), crossings);
    for (std::size_t k = begin; k < crossings.size(); ++k)
      crossings[k].jump += first[f];
  }
  return crossings;
}

std::vector<Bounds> Discontinuities::bounds_there(const Limits &limits) const
{
  std::vector<Bounds> all;
  std::vector<Crossing> crossings;
  for (unsigned int f = 0; f < formulas.size(); ++f)
    all.push_back(formulas[f].get().bounds(bounds, values, limits_of(f, limits),
                                           crossings));
  return all;
}

bool Discontinuities::is_step(const Crossing &crossing,
                              const Point<2> &p,
                              const Limits &limits) const
{
  const InvalidOperationsAllowed allowed;
  place({p, {}});
  // Strictly on either side, also if the argument is at its level.
  const auto beside = [&](const double far) {
    Crossing at_next = crossing;
    at_next.level = std::nextafter(crossing.level, far);
    return bounds_there(on_side(at_next, far < 0., limits));
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto below = beside(-infinity), above = beside(infinity);
  for (unsigned int f = 0; f < formulas.size(); ++f)
  {
    const Interval &lower = below[f].value, &upper = above[f].value;
    const double gap =
        std::max(lower.lower() - upper.upper(), upper.lower() - lower.upper());
    if (gap > rounding_of_values * (magnitude(lower) + magnitude(upper)))
      return true;
  }
  return false;
}

double Discontinuities::distance(const Crossing &crossing,
                                 const Point<2> &p) const
{
  const InvalidOperationsAllowed allowed;
  const unsigned int f =
      std::upper_bound(first.begin(), first.end(), crossing.jump) -
      first.begin() - 1;
  values[0] = p[0];
  values[1] = p[1];
  const double distance =
      formulas[f].get().argument(crossing.jump - first[f], values) -
      crossing.level;
  return std::isnan(distance) ? 0. : distance;
}

Discontinuities::Limits Discontinuities::on_side(const Crossing &crossing,
                                                 const bool is_below,
                                                 Limits limits)
{
  Interval &limit = limits[crossing.jump];
  limit = is_below ? Interval(limit.lower(), crossing.level)
                   : Interval(crossing.level, limit.upper());
  return limits;
}
} // namespace Voussoir
