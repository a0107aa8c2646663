// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/geometry.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/voronoi/voronoi.h>

#include <deal.II/base/tensor.h>

#include <cmath>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/**
 * The centroids of the cells for a density of h^-4, where h is the @p size: by
 * the triangles between the centre and the sides, with the three midpoints of
 * the sides of a triangle, which is exact for polynomials of degree two.
 */
std::vector<Point<2>> weighted_centroids(const CellLoops &cells,
                                         const CellSize<2> &size)
{
  std::vector<Point<2>> centroids;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
  {
    const Point<2> &centre = cells.centres[c];
    const double reference = size(centre);
    double mass = 0.;
    Tensor<1, 2> moment;
    for (unsigned int i = 0; i < cells.n_sides(c); ++i)
    {
      const Tensor<1, 2> a = cells.vertex(c, i + cells.n_sides(c) - 1) - centre;
      const Tensor<1, 2> b = cells.vertex(c, i) - centre;
      const double area = 0.5 * cross(a, b);
      for (const Tensor<1, 2> &x : {0.5 * a, 0.5 * (a + b), 0.5 * b})
      {
        const double weight = std::pow(reference / size(centre + x), 4);
        mass += weight * area / 3.;
        moment += weight * area / 3. * x;
      }
    }
    centroids.push_back(centre + moment / mass);
  }
  return centroids;
}
} // namespace

void VoronoiGenerator::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  add_choice<bool>(
      prm, "Domain", fills_polygon,
      {{false, "rectangle", "from 'Lower left' to 'Upper right'.",
        "Lower left, Upper right"},
       {true, "polygon", "the convex polygon of 'Polygon'.", "Polygon"}},
      "What the cells fill.");
  prm.add_parameter(
      "Lower left", rectangle.lower_left,
      "The lower left corner \"x, y\" of the rectangle; lengths.");
  prm.add_parameter("Upper right", rectangle.upper_right,
                    "The upper right corner \"x, y\" of the rectangle; "
                    "lengths.");
  prm.add_parameter(
      "Polygon", polygon_vertices,
      "The vertices \"x, y; x, y; ...\" of the convex polygon, in "
      "order around it; lengths.");
  points.add_parameters(prm);
}

CellLoops VoronoiGenerator::generate(const std::filesystem::path &directory,
                                     Terminal &terminal) const
{
  const ConvexPolygon polygon = make_domain();
  const CellSize<2> size = points.cell_size();
  size(polygon.vertex(0)); // a constant is not evaluated elsewhere
  return points.relaxed_cells(
      make_points(polygon, size, directory),
      [&](const PointList<2> &of) { return voronoi_cells(of, polygon); },
      [&](const CellLoops &of) { return weighted_centroids(of, size); },
      terminal);
}

ConvexPolygon VoronoiGenerator::make_domain() const
{
  if (!fills_polygon)
  {
    const auto &[lower_left, upper_right] = rectangle;
    if (!std::isfinite(rectangle.area()) || !(upper_right[0] > lower_left[0]) ||
        !(upper_right[1] > lower_left[1]))
      throw InputError("The rectangle of 'Packing/Voronoi' from " +
                       text_of_point(lower_left) + " to " +
                       text_of_point(upper_right) +
                       " has no area; 'Upper right' must be above and to the "
                       "right of 'Lower left'.");
    return ConvexPolygon(rectangle);
  }
  if (polygon_vertices.empty())
    throw InputError("'Packing/Voronoi/Domain' is 'polygon', but 'Packing/"
                     "Voronoi/Polygon' has no vertices.");
  return ConvexPolygon(polygon_vertices);
}

PointList<2>
VoronoiGenerator::make_points(const ConvexPolygon &polygon,
                              const CellSize<2> &size,
                              const std::filesystem::path &directory) const
{
  if (std::optional<PointList<2>> given = points.given_points(directory))
    return std::move(*given);
  if (!fills_polygon && size.is_constant())
    return random_points(points.random_count(), points.random_seed(),
                         rectangle);
  return random_points(points.random_count(), points.random_seed(), polygon,
                       size);
}
} // namespace Voussoir
