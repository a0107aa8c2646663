// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_generators_stairs_h
#define voussoir_packing_polyhedra_generators_stairs_h

#include <voussoir/packing/generators/generator.h>

namespace Voussoir
{
/**
 * A straight flight of cantilevered steps, each of which rests on the one below
 * along its front edge and is built into a wall at one end. The wall begins at
 * the origin; x runs along it, up the flight, and z upwards. Its front is
 * y = 0, from which the steps jut out to negative y.
 *
 * The wall is of one leaf of bricks in running bond, as deep as it is thick;
 * its courses are as high as the steps. Behind the end of a step there is a
 * brick that is as wide as the step, unless the step goes through the wall. A
 * piece of a brick that is narrower than an eighth of one is joined to its
 * neighbour.
 *
 * Cells are boxes, numbered course by course from the bottom: the bricks from
 * left to right, the step and the brick behind it. They belong to the groups
 * "brick" and "step".
 */
class StairsGenerator : public PackingGenerator<3>
{
public:
  std::string name() const override { return "stairs"; }
  std::string meaning() const override
  {
    return "cantilevered steps that are built into a wall at one end.";
  }
  void add_parameters(dealii::ParameterHandler &prm) override;
  CellFaces generate(const std::filesystem::path &directory,
                     Terminal &terminal) const override;

private:
  void check() const;

  unsigned int n_steps = 10;
  double going = 0.28;
  double rise = 0.175;
  double width = 1.;
  double overlap = 0.03;
  double bearing = 0.15;
  double wall_thickness = 0.3;
  double wall_ends = 0.5;
  unsigned int n_courses_above = 4;
  double brick_length = 0.5;
};
} // namespace Voussoir

#endif
