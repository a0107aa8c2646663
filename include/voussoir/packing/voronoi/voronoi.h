// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_voronoi_voronoi_h
#define voussoir_packing_voronoi_voronoi_h

#include <voussoir/packing/generators/generator.h>
#include <voussoir/packing/voronoi/point_entries.h>
#include <voussoir/packing/voronoi/random_points.h>
#include <voussoir/packing/voronoi/voronoi_cells.h>

namespace Voussoir
{
/**
 * The Voronoi cells of points in a rectangle or a convex polygon; the points
 * are read from a file or drawn at random, with a density of 1/h(x, y)^2 where
 * cells of the size h are wanted. Lloyd steps, which move each point to the
 * centroid of its cell, make the cells more alike: with the weight h^-4, since
 * centroidal cells in the plane have a size proportional to the weight's power
 * -1/4 (Gersho's conjecture; Du, Faber and Gunzburger 1999, SIAM Review
 * 41:637). Cells are numbered as their points.
 */
class VoronoiGenerator : public PackingGenerator<2>
{
public:
  std::string name() const override { return "Voronoi"; }
  std::string meaning() const override
  {
    return "the Voronoi cells of points in a rectangle or a convex polygon, of "
           "equal or of graded size.";
  }
  void add_parameters(dealii::ParameterHandler &prm) override;
  CellLoops generate(const std::filesystem::path &directory,
                     Terminal &terminal) const override;
  std::vector<std::filesystem::path>
  input_files(const std::filesystem::path &directory) const override
  {
    return points.input_files(directory);
  }

private:
  ConvexPolygon make_domain() const;
  PointList<2> make_points(const ConvexPolygon &polygon,
                           const CellSize<2> &size,
                           const std::filesystem::path &directory) const;

  bool fills_polygon = false;
  Rectangle rectangle{{0., 0.}, {1., 1.}};
  std::vector<dealii::Point<2>> polygon_vertices;
  PointEntries<2> points;
};
} // namespace Voussoir

#endif
