// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_running_bond_h
#define voussoir_packing_running_bond_h

#include <voussoir/packing/generator.h>

namespace Voussoir
{
/**
 * A rectangular wall of equal bricks with its lower left corner at the origin.
 * Every second course, beginning with the second, is shifted by half a brick
 * and closed by a half brick at either end. Where a head joint meets the middle
 * of a brick, that brick's bed joint is split into two interfaces.
 *
 * Cells are numbered course by course from the bottom, from left to right.
 */
class RunningBondGenerator : public PackingGenerator
{
public:
  std::string name() const override;
  std::string meaning() const override;
  void add_parameters(dealii::ParameterHandler &prm) override;
  CellLoops generate(const std::filesystem::path &directory) const override;

private:
  unsigned int n_courses = 12;
  unsigned int n_bricks = 6;
  double width = 1.;
  double height = 1.;
};
} // namespace Voussoir

#endif
