// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/voronoi/centroids.h>
#include <voussoir/packing/polyhedra/voronoi/voronoi.h>

#include <cmath>

namespace Voussoir
{
namespace
{
/** As many as have faces, and corners of these, that 32 bits can number. */
constexpr int most_space_cells = 40000000;
} // namespace

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
  add_choice<bool>(
      prm, "Points", reads_points,
      {{true, "file", "as given in 'Points file'.", "Points file"},
       {false, "random", "drawn at random, as densely as 'Cell size' asks.",
        "Number of points, Seed"}},
      "Where the points come from.");
  prm.add_parameter("Points file", points_file,
                    "A file with one point \"x y z\" a line; # begins a "
                    "comment. A relative path starts at the directory of the "
                    ".prm file.",
                    Anything());
  prm.add_parameter("Number of points", n_points,
                    "Number of random points, which is that of the cells.",
                    Integer(1, most_space_cells));
  prm.add_parameter("Seed", seed,
                    "Seed of the random points; the same seed gives the same "
                    "points on every machine.",
                    Integer(0));
  prm.add_parameter("Cell size", cell_size,
                    "The size that cells are wanted to have, relative to each "
                    "other: a positive expression in x, y and z, of which only "
                    "ratios matter. It decides how densely random points lie, "
                    "and what Lloyd steps tend to.",
                    Anything());
  prm.add_parameter("Lloyd steps", n_lloyd_steps,
                    "How many times each point is moved to the centroid of its "
                    "cell, weighted by 'Cell size' to the power -5.",
                    Integer(0, 10000));
}

CellFaces
SpaceVoronoiGenerator::generate(const std::filesystem::path &directory,
                                Terminal &terminal) const
{
  const ConvexPolyhedron domain = make_domain();
  const CellSize<3> size(cell_size, "Packing/Voronoi/Cell size");
  size(domain.middle()); // a constant is not evaluated elsewhere
  PointList<3> generators = make_points(domain, size, directory);
  CellFaces cells = voronoi_cells(generators, domain);
  for (unsigned int step = 0; step < n_lloyd_steps; ++step)
  {
    terminal.progress(step, n_lloyd_steps, "Lloyd steps");
    generators.points = weighted_centroids(cells, size);
    cells = voronoi_cells(generators, domain);
  }
  const std::size_t n_corners = domain.faces().vertices.size();
  if (fills_polyhedron && n_corners < polyhedron_points.size())
    cells.notices.push_back(
        text("Of the ", polyhedron_points.size(),
             " points of 'Packing/Voronoi/Polyhedron', ", n_corners,
             " are the corners of a convex polyhedron, which the cells fill; "
             "the others are inside it or repeated."));
  return cells;
}

std::vector<std::filesystem::path>
SpaceVoronoiGenerator::input_files(const std::filesystem::path &directory) const
{
  if (!reads_points || points_file.empty())
    return {};
  return {directory / points_file};
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
  if (reads_points && points_file.empty())
    throw InputError("'Packing/Voronoi/Points' is 'file', but 'Packing/Voronoi/"
                     "Points file' names none.");
  if (reads_points)
    return read_points_file<3>((directory / points_file).lexically_normal());
  if (!fills_polyhedron && size.is_constant())
    return random_points(n_points, seed, box);
  return random_points(n_points, seed, domain, size);
}
} // namespace Voussoir
