// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_generators_column_h
#define voussoir_packing_polyhedra_generators_column_h

#include <voussoir/packing/generators/generator.h>

namespace Voussoir
{
/**
 * One or more columns of drums in a row along x, each on a plinth and with a
 * capital if there are any, and an architrave over them. The axis of the first
 * column is the z axis, the ground is z = 0.
 *
 * A drum is the part of a pyramid whose sections are regular polygons; a side
 * of them faces x. With n sides and the radii a and b of the circles through
 * the corners at its ends, it has the volume
 * n/2 sin(2 pi / n) h (a^2 + a b + b^2)/3. All drums of a column have one
 * height h, and their radii change evenly.
 *
 * Plinth and capital are boxes on a square. The beams of the architrave are
 * boxes that meet above the axes of the columns; the outermost ones end with
 * the capitals, or as far from the axis as the corners of the top drum are.
 *
 * Cells are numbered column by column, in each from the ground up, with the
 * beams behind, and belong to the groups "drum", "plinth", "capital" and
 * "architrave".
 */
class ColumnGenerator : public PackingGenerator<3>
{
public:
  std::string name() const override { return "column"; }
  std::string meaning() const override
  {
    return "columns of drums, with or without an architrave.";
  }
  void add_parameters(dealii::ParameterHandler &prm) override;
  CellFaces generate(const std::filesystem::path &directory,
                     Terminal &terminal) const override;

private:
  void check() const;
  /** The distance from the axis of what carries the architrave; a length. */
  double reach() const;
  /** The height of a bed joint, 0 below the first drum; a length. */
  double bed_joint(unsigned int joint) const;
  /** The height of the top of a column; a length. */
  double height_of_columns() const;

  unsigned int n_drums = 8;
  unsigned int n_sides = 12;
  double bottom_radius = 0.4;
  double top_radius = 0.35;
  double height = 4.;
  double plinth_width = 1.;
  double plinth_height = 0.;
  double capital_width = 1.;
  double capital_height = 0.;
  unsigned int n_columns = 1;
  double spacing = 2.5;
  double architrave_width = 0.6;
  double architrave_height = 0.;
};
} // namespace Voussoir

#endif
