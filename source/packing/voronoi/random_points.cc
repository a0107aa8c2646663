// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/random.h>
#include <voussoir/packing/voronoi/random_points.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace Voussoir
{
using dealii::Point;

namespace
{
/** The least number of triangles into which the polygon is cut. */
constexpr unsigned int least_triangles = 4096;

/**
 * The number of times that the bound in some triangle may be raised. Once or
 * twice is usual for a formula with a peak between the corners; a size that
 * vanishes would raise bounds for ever.
 */
constexpr unsigned int most_raised_bounds = 200;

/**
 * The number of points tried for each that is kept, on average, before the size
 * is taken to vanish somewhere: far more than bounds that fit ever cost.
 */
constexpr double most_tries = 100.;

/** A triangle with an upper bound of the density in it. */
struct Triangle
{
  std::array<Point<2>, 3> corners;
  double area;
  double bound;

  Point<2> at(const double a, const double b) const
  {
    return (1. - a - b) * corners[0] + a * corners[1] + b * corners[2];
  }
};

/** Draws points with the density (reference / h)^2. */
class PointSource
{
public:
  PointSource(const ConvexPolygon &polygon, const CellSize &size) : size(size)
  {
    const unsigned int n = polygon.n_sides();
    Point<2> middle;
    for (unsigned int i = 0; i < n; ++i)
      middle += polygon.vertex(i) / n;
    reference_size = size(middle);

    const unsigned int n_cuts = std::ceil(std::sqrt(1. * least_triangles / n));
    for (unsigned int i = 0; i < n; ++i)
    {
      const double area = -0.5 * polygon.beyond(middle, i) *
                          polygon.vertex(i).distance(polygon.vertex(i + 1));
      add_triangles(
          {{{middle, polygon.vertex(i), polygon.vertex(i + 1)}}, area, 0.},
          n_cuts);
    }
  }

  std::vector<Point<2>> draw(const unsigned int n, const unsigned int seed)
  {
    std::vector<Point<2>> points(n);
    std::optional<Point<2>> excess;
    for (unsigned int raised = 0; raised <= most_raised_bounds; ++raised)
    {
      excess = try_to_draw(points, seed);
      if (!excess)
        return points;
    }
    size.refuse_as_too_small(*excess);
  }

private:
  double density(const Point<2> &p) const
  {
    const double ratio = reference_size / size(p);
    return ratio * ratio;
  }

  /** Cut a triangle into n_cuts^2 equal ones that are similar to it. */
  void add_triangles(const Triangle &whole, const unsigned int n_cuts)
  {
    const double area = whole.area / (n_cuts * n_cuts);
    const auto node = [&](const unsigned int i, const unsigned int j) {
      return whole.at(1. * i / n_cuts, 1. * j / n_cuts);
    };
    for (unsigned int i = 0; i < n_cuts; ++i)
      for (unsigned int j = 0; i + j < n_cuts; ++j)
      {
        add_triangle({{node(i, j), node(i + 1, j), node(i, j + 1)}}, area);
        if (i + j + 1 < n_cuts)
          add_triangle({{node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)}},
                       area);
      }
  }

  void add_triangle(const std::array<Point<2>, 3> &corners, const double area)
  {
    Triangle triangle = {corners, area, 0.};
    const double in_middle = density(triangle.at(1. / 3., 1. / 3.));
    double least = in_middle, largest = in_middle;
    for (const Point<2> &corner : corners)
    {
      const double value = density(corner);
      least = std::min(least, value);
      largest = std::max(largest, value);
    }
    // Between the four points the density may rise as much again.
    raise_bound(triangle, largest + (largest - least));
    triangles.push_back(triangle);
  }

  void raise_bound(Triangle &triangle, const double bound) const
  {
    triangle.bound = bound;
    if (!std::isfinite(bound))
      size.refuse_as_too_small(triangle.at(1. / 3., 1. / 3.));
  }

  /**
   * Draw @p points.
   *
   * @return a point at which the bound was exceeded and is now raised; nothing
   * if all points were drawn.
   */
  std::optional<Point<2>> try_to_draw(std::vector<Point<2>> &points,
                                      const unsigned int seed)
  {
    std::vector<double> mass_up_to;
    double mass = 0.;
    for (const Triangle &triangle : triangles)
    {
      mass += triangle.area * triangle.bound;
      mass_up_to.push_back(mass);
    }
    Random random(seed);
    double tries_left = most_tries * (points.size() + most_tries);
    for (Point<2> &p : points)
      for (bool kept = false; !kept;)
      {
        const auto found = std::upper_bound(
            mass_up_to.begin(), mass_up_to.end() - 1, random() * mass);
        Triangle &triangle = triangles[found - mass_up_to.begin()];
        double a = random(), b = random();
        if (a + b > 1.) // in the other half of the parallelogram
        {
          a = 1. - a;
          b = 1. - b;
        }
        p = triangle.at(a, b);
        const double value = density(p);
        if (--tries_left < 0.)
          size.refuse_as_too_small(p);
        if (value > triangle.bound)
        {
          raise_bound(triangle, 2. * value);
          return p;
        }
        kept = random() * triangle.bound < value;
      }
    return {};
  }

  const CellSize &size;
  double reference_size;
  std::vector<Triangle> triangles;
};

/** The curve tells 2^curve_bits parts of a side from each other. */
constexpr int curve_bits = 16;

/**
 * Put the points in the order in which a Hilbert curve through a square around
 * them meets them. Cells that touch then mostly have numbers close to each
 * other, and their data lies close in memory; in the order of drawing, a
 * million cells take twice as long in all that looks at neighbours.
 */
void order_along_curve(std::vector<Point<2>> &points)
{
  using Place = std::array<std::uint64_t, 2>;
  const dealii::BoundingBox<2> box(points);
  const double size = std::max({box.side_length(0), box.side_length(1),
                                std::numeric_limits<double>::min()});
  std::vector<Place> squares;
  squares.reserve(points.size());
  for (const Point<2> &p : points)
  {
    const auto part = [&](const unsigned int d) -> std::uint64_t {
      return (p[d] - box.lower_bound(d)) / size * ((1 << curve_bits) - 1);
    };
    squares.push_back({{part(0), part(1)}});
  }
  const auto places = dealii::Utilities::inverse_Hilbert_space_filling_curve<2>(
      squares, curve_bits);
  std::vector<std::pair<Place, Point<2>>> placed;
  placed.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    placed.emplace_back(places[i], points[i]);
  std::stable_sort(
      placed.begin(), placed.end(),
      [](const auto &a, const auto &b) { return a.first < b.first; });
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = placed[i].second;
}
} // namespace

PointList random_points(const unsigned int n,
                        const unsigned int seed,
                        const Rectangle &rectangle)
{
  Random random(seed);
  PointList list;
  list.points.resize(n);
  for (Point<2> &p : list.points)
    for (unsigned int i = 0; i < 2; ++i)
      p[i] = rectangle.lower_left[i] +
             random() * (rectangle.upper_right[i] - rectangle.lower_left[i]);
  order_along_curve(list.points);
  return list;
}

PointList random_points(const unsigned int n,
                        const unsigned int seed,
                        const ConvexPolygon &polygon,
                        const CellSize &size)
{
  PointList list;
  list.points = PointSource(polygon, size).draw(n, seed);
  order_along_curve(list.points);
  return list;
}
} // namespace Voussoir
