// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_voronoi_h
#define voussoir_packing_voronoi_h

#include <voussoir/packing/generator.h>
#include <voussoir/packing/voronoi_cells.h>

namespace Voussoir
{
/**
 * The Voronoi cells of a rectangle, of points that are read from a file or
 * drawn at random; Lloyd steps, which move each point to the centroid of its
 * cell, make the cells more alike. Cells are numbered as their points.
 */
class VoronoiGenerator : public PackingGenerator
{
public:
  std::string name() const override;
  std::string meaning() const override;
  void add_parameters(dealii::ParameterHandler &prm) override;
  CellLoops generate(const std::filesystem::path &directory) const override;

private:
  enum class Source
  {
    file,
    random
  };

  void check_rectangle() const;

  Rectangle rectangle{{0., 0.}, {1., 1.}};
  Source source = Source::random;
  std::string points_file;
  unsigned int n_points = 100;
  unsigned int seed = 1;
  unsigned int n_lloyd_steps = 0;
};

/** @p n points drawn uniformly over @p rectangle; a seed gives the same ones.
 */
PointList random_points(unsigned int n,
                        unsigned int seed,
                        const Rectangle &rectangle = {{0., 0.}, {1., 1.}});
} // namespace Voussoir

#endif
