// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_generators_honeycomb_h
#define voussoir_packing_generators_honeycomb_h

#include <voussoir/packing/generators/generator.h>

namespace Voussoir
{
/**
 * A honeycomb of whole regular hexagons: nothing is cut, so that its rim is a
 * zigzag. The smallest rectangle around it has its lower left corner at the
 * origin.
 *
 * With pointed tops, the hexagons of a row stand side by side, and every second
 * row, beginning with the second, is shifted to the right by half a cell. With
 * flat tops, the same holds of columns, which are shifted upwards. Cells are
 * numbered row by row from the bottom, or column by column from the left.
 */
class HoneycombGenerator : public PackingGenerator<2>
{
public:
  std::string name() const override { return "honeycomb"; }
  std::string meaning() const override
  {
    return "whole regular hexagons, every second row shifted by half a cell.";
  }
  void add_parameters(dealii::ParameterHandler &prm) override;
  CellLoops generate(const std::filesystem::path &directory,
                     Terminal &terminal) const override;

private:
  unsigned int n_columns = 10;
  unsigned int n_rows = 10;
  double cell_size = 1.;
  bool pointed = true;
};
} // namespace Voussoir

#endif
