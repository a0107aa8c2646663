// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_generators_perturbed_grid_h
#define voussoir_packing_generators_perturbed_grid_h

#include <voussoir/packing/generators/generator.h>

namespace Voussoir
{
/**
 * A rectangle with its lower left corner at the origin, cut into quadrilaterals
 * by a grid whose vertices are moved at random: those inside in all directions,
 * those on a side along it, and the corners not at all. Cells are numbered row
 * by row from the bottom, from left to right.
 */
class PerturbedGridGenerator : public PackingGenerator<2>
{
public:
  std::string name() const override { return "perturbed grid"; }
  std::string meaning() const override
  {
    return "a rectangle cut into quadrilaterals by a grid with its vertices "
           "moved "
           "at random.";
  }
  void add_parameters(dealii::ParameterHandler &prm) override;
  CellLoops generate(const std::filesystem::path &directory,
                     Terminal &terminal) const override;

private:
  std::vector<dealii::Point<2>> make_vertices() const;

  unsigned int n_columns = 10;
  unsigned int n_rows = 10;
  double width = 1.;
  double height = 1.;
  double perturbation = 0.25;
  unsigned int seed = 1;
};
} // namespace Voussoir

#endif
