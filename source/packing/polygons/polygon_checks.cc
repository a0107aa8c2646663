// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/geometry.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/cgal_result.h>
#include <voussoir/packing/polygons/polygon_checks.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/tensor.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace Voussoir
{
namespace
{
using dealii::Point;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Ring = std::vector<Point<2>>;
using Kind = DrawingFault::Kind;

/** The automatic matching tolerance relative to the mean size of what is drawn.
 */
constexpr double relative_tolerance = 1e-10;

/** The error of coordinates from another program, in units of rounding. */
constexpr double n_units_of_rounding =
    16. * std::numeric_limits<double>::epsilon();

/**
 * The mean thickness of a cell over its length below which it is a sliver: the
 * remains of a cut that failed, not a block. A mortar joint of a millimetre
 * along ten metres has 1e-4.
 */
constexpr double sliver_ratio = 1e-6;

/**
 * The mean thickness of a cell over the tolerance below which matching may take
 * its opposite sides for one another: each may move by the tolerance.
 */
constexpr double least_thickness = 4.;

/** The diagonal of the box around a ring. */
double length_of(const Ring &ring)
{
  const auto [low, high] = dealii::BoundingBox<2>(ring).get_boundary_points();
  return low.distance(high);
}

/** The largest coordinate of all, without sign. */
double largest_coordinate(const PolygonList &polygons)
{
  double largest = 0.;
  for (const PolygonList::Polygon &polygon : polygons.polygons)
    if (!polygon.is_broken && polygon.is_finite())
      for (const Point<2> &p : polygon.ring)
        largest = std::max({largest, std::abs(p[0]), std::abs(p[1])});
  return largest;
}

std::vector<Kernel::Point_2> to_cgal(const Ring &ring)
{
  std::vector<Kernel::Point_2> points;
  points.reserve(ring.size());
  for (const Point<2> &p : ring)
    points.emplace_back(p[0], p[1]);
  return points;
}

/** The place where two sides meet that should not, if they do. */
std::optional<Point<2>> contact_of(const std::vector<Kernel::Point_2> &p,
                                   const std::size_t i,
                                   const std::size_t j)
{
  const std::size_t n = p.size();
  const Kernel::Segment_2 a(p[i], p[(i + 1) % n]), b(p[j], p[(j + 1) % n]);
  const auto contact = CGAL::intersection(a, b);
  if (!contact)
    return {};
  // Sides that follow each other meet in a point; a segment is a spike.
  const Kernel::Point_2 *point = held<Kernel::Point_2>(*contact);
  if (point != nullptr && ((i + 1) % n == j || (j + 1) % n == i))
    return {};
  const Kernel::Point_2 q =
      point != nullptr ? *point : held<Kernel::Segment_2>(*contact)->source();
  return Point<2>(q.x(), q.y());
}

/** The point where a ring that is not simple crosses or touches itself. */
Point<2> place_of_crossing(const std::vector<Kernel::Point_2> &p)
{
  const std::size_t n = p.size();
  const auto left = [&](const std::size_t i) {
    return std::min(p[i].x(), p[(i + 1) % n].x());
  };
  const auto right = [&](const std::size_t i) {
    return std::max(p[i].x(), p[(i + 1) % n].x());
  };
  std::vector<std::size_t> sides(n);
  std::iota(sides.begin(), sides.end(), 0);
  std::sort(sides.begin(), sides.end(), [&](std::size_t i, std::size_t j) {
    return std::make_pair(left(i), i) < std::make_pair(left(j), j);
  });
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t l = k + 1; l < n && left(sides[l]) <= right(sides[k]); ++l)
      if (const auto place = contact_of(p, sides[k], sides[l]))
        return *place;
  return {p[0].x(), p[0].y()};
}

void check_vertices(const PolygonList &polygons, const unsigned int cell)
{
  const Ring &ring = polygons.polygons[cell].ring;
  for (const Point<2> &p : ring)
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]))
      polygons.refuse(Kind::bad_vertex, cell,
                      "has the vertex (" + text_of_number(p[0]) + ", " +
                          text_of_number(p[1]) +
                          "); coordinates must be finite.");
  if (ring.size() < 3)
    polygons.refuse(Kind::bad_vertex, cell,
                    text("has ", ring.size(),
                         " different vertices; a polygon has at least "
                         "three."));
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (ring[i] == ring[(i + 1) % ring.size()])
      polygons.refuse(Kind::bad_vertex, cell,
                      "repeats the vertex " + text_of_point(ring[i]) +
                          "; give each vertex once.");
  if (!std::isfinite(length_of(ring) * length_of(ring)))
    polygons.refuse(Kind::bad_vertex, cell,
                    "at " + text_of_point(ring[0]) +
                        " is too large for its area to be a number; "
                        "choose another unit of length.");
}

/** True if all vertices lie on one line, to rounding. */
bool is_flat(const Ring &ring)
{
  const auto farthest = std::max_element(
      ring.begin(), ring.end(), [&](const Point<2> &a, const Point<2> &b) {
        return a.distance_square(ring[0]) < b.distance_square(ring[0]);
      });
  const dealii::Tensor<1, 2> line = *farthest - ring[0];
  return std::all_of(ring.begin(), ring.end(), [&](const Point<2> &p) {
    return std::abs(cross(line, p - ring[0])) <=
           n_units_of_rounding * line.norm_square();
  });
}

void check_shape(const PolygonList &polygons, const unsigned int cell)
{
  const Ring &ring = polygons.polygons[cell].ring;
  if (is_flat(ring))
    polygons.refuse(Kind::no_area, cell,
                    "at " + text_of_point(ring[0]) +
                        " has no area: all its vertices lie on one line; "
                        "delete or redraw it.");
  const std::vector<Kernel::Point_2> points = to_cgal(ring);
  if (!CGAL::is_simple_2(points.begin(), points.end(), Kernel()))
    polygons.refuse(Kind::self_crossing, cell,
                    "crosses or touches itself at " +
                        text_of_point(place_of_crossing(points)) +
                        "; redraw it as one loop that does neither, or as "
                        "several cells.");
  const double length = length_of(ring);
  const double area = std::abs(signed_area(ring));
  if (area < sliver_ratio * length * length)
    polygons.refuse(Kind::sliver, cell,
                    "at " + text_of_point(ring[0]) +
                        text(" is a sliver of length ", length,
                             " and mean thickness ", area / length,
                             "; delete it, or merge it with a "
                             "neighbour."));
}

/** Refuse a cell whose opposite sides matching could take for one another. */
void check_thickness(const PolygonList &polygons,
                     const unsigned int cell,
                     const double tolerance,
                     const double rounding)
{
  const Ring &ring = polygons.polygons[cell].ring;
  const double thickness = std::abs(signed_area(ring)) / length_of(ring);
  if (thickness < least_thickness * tolerance)
    polygons.refuse(Kind::too_small_to_match, cell,
                    "at " + text_of_point(ring[0]) +
                        text(" has the mean thickness ", thickness,
                             ", which is less than ", least_thickness,
                             " times the matching tolerance ", tolerance,
                             tolerance > rounding
                                 ? "; lower the tolerance or delete the cell."
                                 : ", which is the rounding of the "
                                   "coordinates; choose an origin closer to "
                                   "the cells."));
}
} // namespace

void check_and_orient(PolygonList &polygons)
{
  for (unsigned int c = 0; c < polygons.polygons.size(); ++c)
  {
    PolygonList::Polygon &polygon = polygons.polygons[c];
    polygon.is_broken |= !polygons.passes([&] {
      if (polygon.is_broken)
        return;
      check_vertices(polygons, c);
      check_shape(polygons, c);
    });
    if (!polygon.is_broken && signed_area(polygon.ring) < 0.)
      std::reverse(polygon.ring.begin() + 1,
                   polygon.ring.end()); // the same first vertex
  }
}

double mean_size(const PolygonList &polygons)
{
  double area = 0.;
  unsigned int n = 0;
  for (const PolygonList::Polygon &polygon : polygons.polygons)
    if (!polygon.is_broken)
    {
      area += std::abs(signed_area(polygon.ring));
      ++n;
    }
  return std::sqrt(area / std::max(n, 1u));
}

double tolerance_of(const PolygonList &polygons, const double size)
{
  return std::max(relative_tolerance * size,
                  n_units_of_rounding * largest_coordinate(polygons));
}

double automatic_tolerance(const PolygonList &polygons)
{
  return tolerance_of(polygons, mean_size(polygons));
}

void check_tolerance(PolygonList &polygons, const double tolerance)
{
  const double rounding = n_units_of_rounding * largest_coordinate(polygons);
  if (!std::isfinite(tolerance) || tolerance < rounding)
    throw InputError(text("The matching tolerance ", tolerance,
                          " is below the rounding ", rounding,
                          " of the coordinates of '", polygons.file.string(),
                          "'; give more, or 0 for an automatic value."));
  for (unsigned int c = 0; c < polygons.polygons.size(); ++c)
    polygons.passes([&] {
      if (!polygons.polygons[c].is_broken)
        check_thickness(polygons, c, tolerance, rounding);
    });
}
} // namespace Voussoir
