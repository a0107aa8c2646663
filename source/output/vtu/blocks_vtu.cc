// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/vtu/blocks_vtu.h>
#include <voussoir/output/vtu/vtu_file.h>
#include <voussoir/output/vtu/vtu_values.h>

#include <cmath>
#include <cstdint>
#include <string>

namespace Voussoir
{
using VtuValues::add_cell_field;
using VtuValues::scalar;
using VtuValues::StressInvariants;
using VtuValues::tensor;
using VtuValues::vector;

namespace
{
/** The points of the cells of a packing, all around one and then the next. */
auto points_of(const Packing &packing)
{
  return VtuValues::ItemsByCell{
      packing.n_cells(),
      [&packing](const unsigned int c) { return packing.first_side(c); }};
}

/** A grid of one polygon for each cell, with what is known of any cell. */
VtuFile polygons_of(const Packing &packing)
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
  VtuFile file =
      VtuFile::separate(VtuFile::Shape::polygon,
                        {packing.first_side(packing.n_cells()), fill_points},
                        {packing.n_cells(), fill_ends});
  add_cell_field(file, "cell",
                 [](unsigned int c) { return scalar(std::int32_t(c)); });
  add_cell_field(file, "group", [&packing](unsigned int c) {
    return scalar(std::int32_t(packing.group(c)));
  });
  return file;
}

/** Add the displacement of the points of each cell, and how far it turns. */
void add_motion(VtuFile &file,
                const Packing &packing,
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
  if (!motion.rotation.empty())
    add_cell_field(file, "rotation", [&motion, factor](unsigned int c) {
      return scalar(factor * motion.rotation[c]);
    });
}
} // namespace

void write_blocks_vtu(std::ostream &out, const Results &results)
{
  using Cell = unsigned int;
  const Packing &packing = results.scene.packing;
  VtuFile grid = polygons_of(packing);
  const auto add = [&grid](const std::string &name, const auto &value) {
    add_cell_field(grid, name, value);
  };
  const auto &stress = results.mean_stresses;
  const auto invariants = [&](Cell c) { return StressInvariants(stress[c]); };
  add("load", [&](Cell c) { return vector(results.scene.load[c]); });
  add("stress", [&](Cell c) { return tensor(stress[c]); });
  add("principal_stress_1",
      [&](Cell c) { return scalar(invariants(c).principal_1); });
  add("principal_stress_2",
      [&](Cell c) { return scalar(invariants(c).principal_2); });
  add("von_mises", [&](Cell c) { return scalar(invariants(c).von_mises); });
  add("torque", [&](Cell c) { return scalar(results.torques[c]); });
  add_motion(grid, packing, results.motion, 1.);
  grid.write(out);
}

void write_mechanism_vtu(std::ostream &out,
                         const Packing &packing,
                         const Motion &motion,
                         const double factor)
{
  VtuFile grid = polygons_of(packing);
  add_motion(grid, packing, motion, factor);
  grid.write(out);
}
} // namespace Voussoir
