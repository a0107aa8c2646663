// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_generators_wall_h
#define voussoir_packing_polyhedra_generators_wall_h

#include <voussoir/packing/generators/generator.h>
#include <voussoir/packing/polyhedra/generators/wall_bond.h>

#include <array>
#include <vector>

namespace Voussoir
{
/**
 * A wall of bricks, of one leaf or several or in a bond through its thickness,
 * with openings and lintels over them. It begins at the origin; x runs along
 * it, y from its front to its back and z upwards. There is no mortar: bricks
 * are as large as they are with their share of the joints.
 *
 * Bricks are cut at the ends of the wall, at the jambs of an opening and at the
 * ends of a lintel. A piece that is narrower than an eighth of a brick is
 * joined to its neighbour in the row, or to a lintel if there is no brick, so
 * that there are no slivers. Lintels are as deep as the wall.
 *
 * Cells are boxes, numbered course by course from the bottom; in a course by
 * rows from the front to the back, in a row from left to right, and where
 * bricks lie side by side in a row from the front to the back. The lintels in a
 * course come last. Cells belong to the groups "brick", "lintel" and "through
 * stone".
 */
class SpaceWallGenerator : public PackingGenerator<3>
{
public:
  std::string name() const override { return "wall"; }
  std::string meaning() const override
  {
    return "a wall of bricks, of one or more leaves, with openings.";
  }
  void add_parameters(dealii::ParameterHandler &prm) override;
  CellFaces generate(const std::filesystem::path &directory,
                     Terminal &terminal) const override;

private:
  /** What follows from the parameters. */
  struct Numbers
  {
    unsigned int n_courses; /**< the height in courses */
    unsigned int n_widths;  /**< the thickness in brick widths */
  };
  void add_parameters_of_openings(dealii::ParameterHandler &prm);
  Numbers check() const;
  /** True if a course has through stones, if there is more than one leaf. */
  bool has_through_stones(unsigned int course) const;

  WallBond bond = WallBond::running;
  bool begins_with_second = false;
  double length = 2.;
  double thickness = 0.2;
  double height = 1.;
  double brick_length = 0.4;
  double brick_width = 0.2;
  double brick_height = 0.1;
  unsigned int through_stone_spacing = 0;
  unsigned int through_stone_courses = 1;
  std::vector<std::array<double, 4>> openings;
  bool has_lintels = true;
  double lintel_bearing = 0.1;
};
} // namespace Voussoir

#endif
