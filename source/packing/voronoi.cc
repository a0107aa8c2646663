// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/voronoi.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include <cmath>

namespace Voussoir
{
std::string VoronoiGenerator::name() const
{
  return "Voronoi";
}

std::string VoronoiGenerator::meaning() const
{
  return "the Voronoi cells of points in a rectangle.";
}

void VoronoiGenerator::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.add_parameter(
      "Lower left", rectangle.lower_left,
      "The lower left corner \"x, y\" of the rectangle; lengths.");
  prm.add_parameter("Upper right", rectangle.upper_right,
                    "The upper right corner \"x, y\" of the rectangle; "
                    "lengths.");
  add_choice<Source>(
      prm, "Points", source,
      {{Source::file, "file", "as given in 'Points file'."},
       {Source::random, "random", "drawn uniformly over the rectangle."}},
      "Where the points come from.");
  prm.add_parameter("Points file", points_file,
                    "A file with one point \"x y\" a line; # begins a comment. "
                    "A relative path starts at the directory of the .prm file.",
                    Anything());
  prm.add_parameter("Number of points", n_points,
                    "Number of random points, which is that of the cells.",
                    Integer(1, 100000000));
  prm.add_parameter("Seed", seed,
                    "Seed of the random points; the same seed gives the same "
                    "points on every machine.",
                    Integer(0));
  prm.add_parameter("Lloyd steps", n_lloyd_steps,
                    "How many times each point is moved to the centroid of its "
                    "cell.",
                    Integer(0, 10000));
}

CellLoops
VoronoiGenerator::generate(const std::filesystem::path &directory) const
{
  check_rectangle();
  if (source == Source::file && points_file.empty())
    throw InputError("'Packing/Voronoi/Points' is 'file', but 'Packing/Voronoi/"
                     "Points file' names none.");

  PointList generators =
      source == Source::file
          ? read_points_file((directory / points_file).lexically_normal())
          : random_points(n_points, seed, rectangle);
  CellLoops cells = voronoi_cells(generators, rectangle);
  for (unsigned int step = 0; step < n_lloyd_steps; ++step)
  {
    cells.centres.clear(); // so that the packing takes the centroids
    const Packing packing(std::move(cells));
    for (unsigned int c = 0; c < packing.n_cells(); ++c)
      generators.points[c] = packing.centre(c);
    cells = voronoi_cells(generators, rectangle);
  }
  return cells;
}

void VoronoiGenerator::check_rectangle() const
{
  bool valid = std::isfinite(rectangle.area());
  for (unsigned int i = 0; i < 2; ++i)
    valid &= rectangle.upper_right[i] > rectangle.lower_left[i];
  if (!valid)
    throw InputError("The rectangle of 'Packing/Voronoi' from " +
                     text_of_point(rectangle.lower_left) + " to " +
                     text_of_point(rectangle.upper_right) +
                     " has no area; 'Upper right' must be above and to the "
                     "right of 'Lower left'.");
}

PointList random_points(const unsigned int n,
                        const unsigned int seed,
                        const Rectangle &rectangle)
{
  // Boost's generator and distribution, unlike the standard library's, are
  // specified to the last bit.
  boost::random::mt19937_64 engine(seed);
  boost::random::uniform_01<double> uniform;
  PointList list;
  list.points.resize(n);
  for (dealii::Point<2> &p : list.points)
    for (unsigned int i = 0; i < 2; ++i)
      p[i] = rectangle.lower_left[i] +
             uniform(engine) *
                 (rectangle.upper_right[i] - rectangle.lower_left[i]);
  return list;
}
} // namespace Voussoir
