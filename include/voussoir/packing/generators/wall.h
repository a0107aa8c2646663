// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_generators_wall_h
#define voussoir_packing_generators_wall_h

#include <voussoir/packing/generators/bond.h>
#include <voussoir/packing/generators/generator.h>

#include <array>

namespace Voussoir
{
/**
 * A rectangular wall of bricks with its lower left corner at the origin, with
 * openings and lintels over them. Where a head joint meets the middle of a
 * brick, that brick's bed joint is split into two interfaces.
 *
 * Bricks are cut at the jambs of an opening and at the ends of a lintel. A
 * piece that is narrower than a quarter of a header is joined to its neighbour
 * in the course, to a brick rather than to a lintel, so that there are no
 * slivers.
 *
 * Cells are numbered course by course from the bottom, from left to right, and
 * belong to the groups "brick" and "lintel".
 */
class WallGenerator : public PackingGenerator<2>
{
public:
  std::string name() const override { return "wall"; }
  std::string meaning() const override
  {
    return "a rectangular wall of bricks, with openings.";
  }
  void add_parameters(dealii::ParameterHandler &prm) override;
  CellLoops generate(const std::filesystem::path &directory,
                     Terminal &terminal) const override;

private:
  Bond bond = Bond::running;
  bool begins_with_second = false;
  unsigned int n_courses = 12;
  unsigned int n_bricks = 6;
  double width = 1.;
  double height = 1.;
  std::vector<std::array<double, 4>> openings;
  bool has_lintels = true;
  double lintel_bearing = 0.1;
};
} // namespace Voussoir

#endif
