// SPDX-License-Identifier: LGPL-2.1-or-later

// The generator of Voronoi packings in space: the seed decides, random points
// have a density of 1/h^3, Lloyd steps make the cells alike and keep the
// gradation, points come from files as they are.

#include <voussoir/packing/polyhedra/cell_moments.h>
#include <voussoir/packing/polyhedra/voronoi/centroids.h>
#include <voussoir/packing/polyhedra/voronoi/voronoi.h>

#include "tests.h"
#include <fstream>

namespace test_space_voronoi_generator
{
using namespace Voussoir;
using dealii::Point;

CellFaces generate(const std::string &settings)
{
  SpaceVoronoiGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.parse_input_from_string(settings);
  return generator.generate(".", Terminal::silent());
}

std::vector<double> volumes_of(const CellFaces &cells)
{
  std::vector<double> volumes;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
    volumes.push_back(moments_of(cells, c).volume);
  return volumes;
}

/** Standard deviation over mean of the volumes over the power -3 of a size. */
double spread(const CellFaces &cells, const std::string &formula)
{
  const CellSize<3> size(formula, "size");
  const std::vector<double> volumes = volumes_of(cells);
  double sum = 0., squares = 0.;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
  {
    const double ratio = volumes[c] / std::pow(size(cells.centres[c]), 3);
    sum += ratio;
    squares += ratio * ratio;
  }
  return std::sqrt(squares * cells.n_cells() / sum / sum - 1.);
}

/** Mean edge of the cells with centres between two heights. */
double mean_size(const CellFaces &cells, const double from, const double to)
{
  const std::vector<double> volumes = volumes_of(cells);
  double volume = 0.;
  unsigned int n = 0;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
    if (cells.centres[c][2] > from && cells.centres[c][2] < to)
    {
      volume += volumes[c];
      ++n;
    }
  return std::cbrt(volume / n);
}

/** The number of n points below z, over its standard deviation from n p. */
double deviation(const PointList<3> &list, const double z, const double p)
{
  const double n = list.points.size();
  const auto n_below =
      std::count_if(list.points.begin(), list.points.end(),
                    [&](const Point<3> &q) { return q[2] < z; });
  return std::abs(n_below - n * p) / std::sqrt(n * p * (1. - p));
}

void check_density()
{
  const Box box{{0., 0., 0.}, {1., 1., 1.}};
  const ConvexPolyhedron cube(box);
  const auto draw = [&](const std::string &h) {
    return random_points(40000, 3, cube, CellSize<3>(h, "size"));
  };
  check("uniform", deviation(random_points(40000, 3, box), 0.3, 0.3) < 3.);
  check("h = 7", deviation(draw("7"), 0.3, 0.3) < 3.);
  // The integral of (1 + z)^-3 is 5/18 up to a half, 3/8 in all.
  check("h = 1 + z", deviation(draw("1 + z"), 0.5, 20. / 27.) < 3.);
  check("a jump", deviation(draw("z < 0.4321 ? 1 : 3"), 0.4321,
                            0.4321 / (0.4321 + 0.5679 / 27)) < 3.);
  // The mass below a height z: z^3 upside down.
  const ConvexPolyhedron tetrahedron(
      std::vector<Point<3>>{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0, 0, 0}});
  const PointList<3> list =
      random_points(40000, 5, tetrahedron, CellSize<3>("1", "size"));
  check("a tetrahedron", deviation(list, 0.5, 0.125) < 3.);
  check("  all inside", std::all_of(list.points.begin(), list.points.end(),
                                    [&](const Point<3> &p) {
                                      return tetrahedron.contains(p, -1e-15);
                                    }));
  double step = 0.;
  for (unsigned int i = 1; i < list.points.size(); ++i)
    step += list.points[i].distance(list.points[i - 1]) / list.points.size();
  check("  along a curve", step < 0.04);
}

void check_gradation()
{
  const std::string many = "set Number of points = 800\nset Seed = 5\n";
  const CellFaces random = generate(many);
  const CellFaces again = generate(many);
  const CellFaces other = generate("set Number of points = 800\nset Seed = 6");
  check("same seed, same cells",
        random.centres == again.centres && random.loops == again.loops);
  check("another seed, other points", random.centres != other.centres);
  // Volumes of Voronoi cells of random points spread by 0.42 of their mean, and
  // a little more at the sides.
  check("spread of random cells", std::abs(spread(random, "1") - 0.44) < 0.04);
  check("twelve Lloyd steps leave less than a third of that",
        spread(generate(many + "set Lloyd steps = 12"), "1") < 0.42 / 3);

  const std::string smooth = "set Cell size = 1 + 2*z\n";
  const CellFaces graded = generate(many + smooth);
  const CellFaces lloyd = generate(many + smooth + "set Lloyd steps = 12\n");
  check("cells at the top as much larger",
        std::abs(mean_size(graded, 0.7, 0.9) / mean_size(graded, 0.2, 0.4) /
                     (2.6 / 1.6) -
                 1.) < 0.15);
  check("which Lloyd steps keep",
        std::abs(mean_size(lloyd, 0.7, 0.9) / mean_size(lloyd, 0.2, 0.4) /
                     (2.6 / 1.6) -
                 1.) < 0.1);
  check("and make alike", spread(lloyd, "1 + 2*z") < 0.42 / 2);
  check("only ratios matter",
        generate(many + "set Cell size = (1 + 2*z) / 8").centres ==
            graded.centres);
}

/** Of the unit cube as one cell, weighted by z^-5 from 1 to 2. */
void check_centroids()
{
  const ConvexPolyhedron cube(Box{{0., 0., 1.}, {1., 1., 2.}});
  PointList<3> list;
  list.points = {{0.3, 0.6, 1.2}};
  const CellFaces one = voronoi_cells(list, cube);
  const auto constant = weighted_centroids(one, CellSize<3>("4", "size"));
  check_error("centroid", constant[0].distance({0.5, 0.5, 1.5}), 1e-15);
  // A constant that is not known to be one: the rule, which then is exact.
  const auto rule = weighted_centroids(one, CellSize<3>("2 + 0*x", "size"));
  check_error("by the rule", rule[0].distance({0.5, 0.5, 1.5}), 1e-15);
  // In many cells: (1 - 2^-3) / 3 over (1 - 2^-4) / 4.
  const CellFaces cells = voronoi_cells(
      random_points(1000, 1, Box{{0., 0., 1.}, {1., 1., 2.}}), cube);
  const CellSize<3> size("z", "size");
  const auto centroids = weighted_centroids(cells, size);
  double mass = 0., moment = 0.;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
  {
    const double weight =
        moments_of(cells, c).volume / std::pow(centroids[c][2], 5);
    mass += weight;
    moment += weight * centroids[c][2];
  }
  check_error("weighted by z^-5", std::abs(moment / mass - 56. / 45.), 1e-3);
}

void check_files()
{
  std::ofstream("space.txt") << "# x y z\n0.25 0.5 0.5\n.5;.5,.5 # a half\n";
  const CellFaces cells =
      generate("set Points = file\nset Points file = space.txt");
  const std::vector<Point<3>> expected = {{0.25, 0.5, 0.5}, {0.5, 0.5, 0.5}};
  check("points of a file",
        cells.centres == expected && volumes_of(cells)[0] == 0.375);
  const CellFaces hull = generate(
      "set Domain = polyhedron\nset Polyhedron = 0, 0, 0; 4, 0, 0; 0, 4, 0; "
      "0, 0, 4; 1, 1, 1; 2, 0, 0\nset Number of points = 50");
  double volume = 0.;
  for (const double of_cell : volumes_of(hull))
    volume += of_cell;
  check_error("volume of a polyhedron", std::abs(volume - 32. / 3.), 1e-13);
  for (const std::string &notice : hull.notices)
    std::cout << notice << std::endl;
}

void run()
{
  check_density();
  check_gradation();
  check_centroids();
  check_files();
}

const RoomTest test("space_voronoi_generator", run);
} // namespace test_space_voronoi_generator
