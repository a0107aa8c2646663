// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/voronoi/centroids.h>
#include <voussoir/packing/polyhedra/voronoi/voronoi.h>

#include <cmath>

namespace Voussoir
{
void SpaceVoronoiGenerator::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  add_choice<bool>(
      prm, "Domain", fills_polyhedron,
      {{false, "box", "from 'Lower corner' to 'Upper corner'.",
        "Lower corner, Upper corner"},
       {true, "polyhedron", "the convex hull of the points of 'Polyhedron'.",
        "Polyhedron"}},
      "What the cells fill.");
  prm.add_parameter("Lower corner", box.lower,
                    "The corner \"x, y, z\" of the box where all coordinates "
                    "are least; lengths.");
  prm.add_parameter("Upper corner", box.upper,
                    "The corner \"x, y, z\" of the box where all coordinates "
                    "are largest; lengths.");
  prm.add_parameter("Polyhedron", polyhedron_points,
                    "The corners \"x, y, z; x, y, z; ...\" of the convex "
                    "polyhedron, in any order; lengths.");
  points.add_parameters(prm);
}

CellFaces
SpaceVoronoiGenerator::generate(const std::filesystem::path &directory,
                                Terminal &terminal) const
{
  const ConvexPolyhedron domain = make_domain();
  const CellSize<3> size = points.cell_size();
  size(domain.middle()); // a constant is not evaluated elsewhere
  CellFaces cells = points.relaxed_cells(
      make_points(domain, size, directory),
      [&](const PointList<3> &of) { return voronoi_cells(of, domain); },
      [&](const CellFaces &of) { return weighted_centroids(of, size); },
      terminal);
  const std::size_t n_corners = domain.faces().vertices.size();
  if (fills_polyhedron && n_corners < polyhedron_points.size())
    cells.notices.push_back(
        text("Of the ", polyhedron_points.size(),
             " points of 'Packing/Voronoi/Polyhedron', ", n_corners,
             " are the corners of a convex polyhedron, which the cells fill; "
             "the others are inside it or repeated."));
  return cells;
}

ConvexPolyhedron SpaceVoronoiGenerator::make_domain() const
{
  if (fills_polyhedron)
  {
    if (polyhedron_points.empty())
      throw InputError("'Packing/Voronoi/Domain' is 'polyhedron', but 'Packing/"
                       "Voronoi/Polyhedron' has no points.");
    return ConvexPolyhedron(polyhedron_points);
  }
  bool has_volume = std::isfinite(box.volume());
  for (unsigned int d = 0; d < 3; ++d)
    has_volume &= box.upper[d] > box.lower[d];
  if (!has_volume)
    throw InputError("The box of 'Packing/Voronoi' from " +
                     text_of_point(box.lower) + " to " +
                     text_of_point(box.upper) +
                     " has no volume; all coordinates of 'Upper corner' must "
                     "be larger than those of 'Lower corner'.");
  return ConvexPolyhedron(box);
}

PointList<3>
SpaceVoronoiGenerator::make_points(const ConvexPolyhedron &domain,
                                   const CellSize<3> &size,
                                   const std::filesystem::path &directory) const
{
  if (std::optional<PointList<3>> given = points.given_points(directory))
    return std::move(*given);
  if (!fills_polyhedron && size.is_constant())
    return random_points(points.random_count(), points.random_seed(), box);
  return random_points(points.random_count(), points.random_seed(), domain,
                       size);
}
} // namespace Voussoir
