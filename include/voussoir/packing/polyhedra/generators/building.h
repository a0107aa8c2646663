// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_generators_building_h
#define voussoir_packing_polyhedra_generators_building_h

#include <voussoir/packing/generators/generator.h>

#include <array>
#include <vector>

namespace Voussoir
{
/**
 * Four walls of one leaf of bricks in running bond on a rectangular plan, with
 * openings and lintels over them. One outer corner is the origin, x runs along
 * the south wall, y along the west wall and z upwards.
 *
 * The walls interlock at the corners: in even courses, from 0 at the bottom,
 * the south and the north wall fill the corners, in odd courses the west and
 * the east wall. The head joints of two courses of a wall are half a brick
 * apart. Where a corner is as wide as about 1, 2, ... bricks are long, the
 * course that fills it begins with a half brick, so that no joint is above
 * another there. As in the wall, a piece narrower than an eighth of a brick is
 * joined to its neighbour.
 *
 * Cells are boxes, numbered course by course from the bottom; in a course the
 * south, north, west and east wall follow each other, in a wall the bricks, by
 * ascending coordinates, and the lintels behind. Cells belong to the groups
 * "brick" and "lintel".
 */
class BuildingGenerator : public PackingGenerator<3>
{
public:
  std::string name() const override { return "building"; }
  std::string meaning() const override
  {
    return "four walls that interlock at the corners, with openings.";
  }
  void add_parameters(dealii::ParameterHandler &prm) override;
  CellFaces generate(const std::filesystem::path &directory,
                     Terminal &terminal) const override;

private:
  unsigned int check() const;

  double length = 4.;
  double width = 3.2;
  double height = 2.;
  double thickness = 0.2;
  double brick_length = 0.4;
  double brick_height = 0.2;
  /** Of the south, north, west and east wall. */
  std::array<std::vector<std::array<double, 4>>, 4> openings;
  bool has_lintels = true;
  double lintel_bearing = 0.2;
};
} // namespace Voussoir

#endif
