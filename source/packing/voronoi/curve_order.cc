// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/voronoi/curve_order.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>

namespace Voussoir
{
using dealii::Point;

namespace
{
/** The curve tells 2^curve_bits parts of a side from each other. */
constexpr int curve_bits = 16;
} // namespace

template <int dim>
void order_along_curve(std::vector<Point<dim>> &points)
{
  if (points.empty())
    return;
  using Place = std::array<std::uint64_t, dim>;
  const dealii::BoundingBox<dim> box(points);
  double size = std::numeric_limits<double>::min();
  for (unsigned int d = 0; d < dim; ++d)
    size = std::max(size, box.side_length(d));
  std::vector<Place> squares;
  squares.reserve(points.size());
  for (const Point<dim> &p : points)
  {
    Place parts;
    for (unsigned int d = 0; d < dim; ++d)
      parts[d] = (p[d] - box.lower_bound(d)) / size * ((1 << curve_bits) - 1);
    squares.push_back(parts);
  }
  const auto places =
      dealii::Utilities::inverse_Hilbert_space_filling_curve<dim>(squares,
                                                                  curve_bits);
  std::vector<std::pair<Place, Point<dim>>> placed;
  placed.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    placed.emplace_back(places[i], points[i]);
  std::stable_sort(
      placed.begin(), placed.end(),
      [](const auto &a, const auto &b) { return a.first < b.first; });
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = placed[i].second;
}

template void order_along_curve<2>(std::vector<Point<2>> &);
template void order_along_curve<3>(std::vector<Point<3>> &);
} // namespace Voussoir
