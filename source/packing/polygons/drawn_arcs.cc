// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/packing/polygons/drawn_arcs.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
using dealii::Point;
using Points = std::vector<Point<2>>;

/** The difference of bulges by which a curve is no arc, relative to them. */
constexpr double noncircular = 1e-6;

/** The step along curves that are no arcs, in degrees: that of GDAL. */
constexpr double usual_step = 4.;

/** True if the points from @p first to @p last lie on one arc. */
bool is_arc(const Points &points,
            const std::size_t first,
            const std::size_t last)
{
  const auto bulge_at = [&](const std::size_t quarters) {
    return bulge_through(points[first],
                         points[first + quarters * (last - first) / 4],
                         points[last]);
  };
  if (last - first < 4)
    return true; // too short to tell
  const double bulge = bulge_at(2);
  return std::max(std::abs(bulge_at(1) - bulge),
                  std::abs(bulge_at(3) - bulge)) <=
         noncircular * (1. + bulge * bulge);
}

/** Go on along fine points, from the one where @p chain ends. */
void add_curve(DrawnChain &chain,
               const Points &fine,
               const std::size_t first,
               const std::size_t last)
{
  const std::size_t n = last - first, middle = first + n / 2;
  const bool is_whole = fine[first] == fine[last];
  if (!is_whole && is_arc(fine, first, last))
    return chain.add_arc(fine[middle], fine[last]);
  if (is_whole && is_arc(fine, first, middle) && is_arc(fine, middle, last))
  {
    chain.add_arc(fine[(first + middle) / 2], fine[middle]);
    return chain.add_arc(fine[(middle + last) / 2], fine[last]);
  }
  chain.has_other_curves = true;
  const std::size_t n_steps =
      std::max(1., std::ceil(n * fine_step / usual_step));
  for (std::size_t k = 1; k <= n_steps; ++k)
    chain.add(fine[first + k * n / n_steps]);
}
} // namespace

void DrawnChain::add(const Point<2> &point, const double bulge)
{
  if (!points.empty())
    bulges.push_back(bulge);
  points.push_back(point);
}

void DrawnChain::add_arc(const Point<2> &middle, const Point<2> &end)
{
  const Point<2> start = points.back();
  if (middle == start || middle == end)
    add(end);
  else if (start == end)
  {
    // A half each; which way round is not told, and does not matter.
    add(middle, 1.);
    add(end, 1.);
  }
  else
    add(end, bulge_through(start, middle, end));
}

void DrawnChain::append(const DrawnChain &other)
{
  for (std::size_t i = points.empty() ? 0 : 1; i < other.points.size(); ++i)
    add(other.points[i], i == 0 ? 0. : other.bulges[i - 1]);
  has_other_curves |= other.has_other_curves;
}

double bulge_through(const Point<2> &start,
                     const Point<2> &middle,
                     const Point<2> &end)
{
  // Half of the angle of the arc is what the chain of chords turns by.
  const dealii::Tensor<1, 2> first = middle - start, second = end - middle;
  return std::tan(0.5 * std::atan2(cross(first, second), first * second));
}

DrawnChain chain_between(const Points &coarse, const Points &fine)
{
  DrawnChain chain;
  std::size_t j = 0;
  for (std::size_t i = 0; i < coarse.size(); ++i)
  {
    if (i == 0)
    {
      chain.add(coarse[0]);
      continue;
    }
    const auto end = std::find(fine.begin() + std::min(j + 1, fine.size()),
                               fine.end(), coarse[i]);
    const std::size_t k = end - fine.begin();
    if (end == fine.end() || k == j + 1)
      chain.add(coarse[i]);
    else
      add_curve(chain, fine, j, k);
    if (end != fine.end())
      j = k;
  }
  return chain;
}
} // namespace Voussoir
