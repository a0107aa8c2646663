// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_voronoi_voronoi_h
#define voussoir_packing_polyhedra_voronoi_voronoi_h

#include <voussoir/packing/generators/generator.h>
#include <voussoir/packing/polyhedra/voronoi/random_points.h>
#include <voussoir/packing/polyhedra/voronoi/voronoi_cells.h>
#include <voussoir/packing/voronoi/point_entries.h>

#include <string>
#include <vector>

namespace Voussoir
{
/**
 * The Voronoi cells of points in a box or a convex polyhedron; the points are
 * read from a file or drawn at random, with a density of 1/h(x, y, z)^3 where
 * cells of the size h are wanted. Lloyd steps, which move each point to the
 * centroid of its cell, make the cells more alike: with the weight h^-5, since
 * centroidal cells in space have a size proportional to the weight's power -1/5
 * (Gersho's conjecture; Du, Faber and Gunzburger 1999, SIAM Review 41:637).
 * Cells are numbered as their points.
 */
class SpaceVoronoiGenerator : public PackingGenerator<3>
{
public:
  std::string name() const override { return "Voronoi"; }
  std::string meaning() const override
  {
    return "the Voronoi cells of points in a box or a convex polyhedron, of "
           "equal or of graded size.";
  }
  void add_parameters(dealii::ParameterHandler &prm) override;
  CellFaces generate(const std::filesystem::path &directory,
                     Terminal &terminal) const override;
  std::vector<std::filesystem::path>
  input_files(const std::filesystem::path &directory) const override
  {
    return points.input_files(directory);
  }

private:
  ConvexPolyhedron make_domain() const;
  PointList<3> make_points(const ConvexPolyhedron &domain,
                           const CellSize<3> &size,
                           const std::filesystem::path &directory) const;

  bool fills_polyhedron = false;
  Box box{{0., 0., 0.}, {1., 1., 1.}};
  std::vector<dealii::Point<3>> polyhedron_points;
  PointEntries<3> points;
};
} // namespace Voussoir

#endif
