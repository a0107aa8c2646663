// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/tables.h>
#include <voussoir/output/vtu/blocks_vtu.h>
#include <voussoir/output/vtu/field_arrays.h>
#include <voussoir/output/vtu/vtu_values.h>

#include <cstdint>

namespace Voussoir
{
using VtuValues::vector;

namespace
{
/** The points of the cells of a packing, all around one and then the next. */
auto points_of(const Packing<2> &packing)
{
  return VtuValues::ItemsByCell{
      packing.n_cells(),
      [&packing](const unsigned int c) { return packing.first_side(c); }};
}

/** A grid of one polygon for each cell. */
VtuFile polygons_of(const Packing<2> &packing)
{
  const auto fill_points = [&packing](auto begin, auto end, double *place) {
    points_of(packing).fill(begin, end, place,
                            [&](unsigned int c, unsigned int k) {
                              return vector(packing.vertex(c, k));
                            });
  };
  const auto fill_ends = [&packing](auto begin, auto end, std::int64_t *place) {
    for (; begin < end; ++begin)
      *place++ = packing.first_side(begin + 1);
  };
  return VtuFile::separate(VtuFile::Shape::polygon,
                           {packing.first_side(packing.n_cells()), fill_points},
                           {packing.n_cells(), fill_ends});
}

/** Add the displacement of the points of each cell. */
void add_displacement(VtuFile &file,
                      const Packing<2> &packing,
                      const Motion &motion,
                      const double factor)
{
  file.add_point_vector(
      "displacement",
      [&packing, &motion, factor](auto begin, auto end, double *place) {
        points_of(packing).fill(
            begin, end, place, [&](unsigned int c, unsigned int k) {
              return vector(factor * motion.at(c, packing.vertex(c, k) -
                                                      packing.centre(c)));
            });
      });
}
} // namespace

void write_blocks_vtu(std::ostream &out, const Results &results)
{
  const Packing<2> &packing = results.scene.packing;
  VtuFile grid = polygons_of(packing);
  add_fields(grid, cell_fields().arrays(results));
  add_displacement(grid, packing, results.motion, 1.);
  grid.write(out);
}

void write_mechanism_vtu(std::ostream &out,
                         const Scene &scene,
                         const Motion &motion,
                         const double factor)
{
  Motion scaled = motion;
  for (double &angle : scaled.rotation)
    angle *= factor;
  const MovingScene moving(scene, scaled);
  VtuFile grid = polygons_of(scene.packing);
  add_fields(grid, mechanism_fields().arrays(moving));
  add_displacement(grid, scene.packing, motion, factor);
  grid.write(out);
}
} // namespace Voussoir
