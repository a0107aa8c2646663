// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/generators/measures.h>
#include <voussoir/packing/polyhedra/generators/block_builder.h>
#include <voussoir/packing/polyhedra/generators/stairs.h>
#include <voussoir/packing/polyhedra/generators/wall_courses.h>

namespace Voussoir
{
namespace
{
/** The numbers of the groups of cells. */
constexpr unsigned int brick_of_stairs = 0;
constexpr unsigned int step_of_stairs = 1;
} // namespace

void StairsGenerator::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.add_parameter("Steps", n_steps, "Number of steps.", Integer(1, 1000000));
  prm.add_parameter("Going", going,
                    "Distance of the fronts of two steps; a length, positive.",
                    Double(0.));
  prm.add_parameter("Rise", rise,
                    "Height of a step and of a course of the wall; a length, "
                    "positive.",
                    Double(0.));
  prm.add_parameter("Width", width,
                    "How far the steps jut out of the wall; a length, "
                    "positive.",
                    Double(0.));
  prm.add_parameter("Overlap", overlap,
                    "How far a step rests on the one below, and is longer than "
                    "'Going'; a length, positive.",
                    Double(0.));
  prm.add_parameter("Bearing", bearing,
                    "How far the steps reach into the wall; a length, "
                    "positive, 'Wall thickness' at most.",
                    Double(0.));
  prm.add_parameter("Wall thickness", wall_thickness,
                    "Thickness of the wall; a length, positive.", Double(0.));
  prm.add_parameter("Wall ends", wall_ends,
                    "How far the wall goes on in front of the first step and "
                    "behind the last one; a length.",
                    Double(0.));
  prm.add_parameter("Courses above", n_courses_above,
                    "Number of courses of the wall above the top step.",
                    Integer(0, 1000000));
  prm.add_parameter("Brick length", brick_length,
                    "Length of the bricks of the wall, a joint included; a "
                    "length, positive.",
                    Double(0.));
}

void StairsGenerator::check() const
{
  std::vector<Measure> measures = {{"Going", going},
                                   {"Rise", rise},
                                   {"Width", width},
                                   {"Overlap", overlap},
                                   {"Bearing", bearing},
                                   {"Wall thickness", wall_thickness},
                                   {"Brick length", brick_length}};
  if (wall_ends != 0.)
    measures.push_back({"Wall ends", wall_ends});
  check_measures("Packing/stairs", measures);
  if (bearing > wall_thickness && !is_same_length(bearing, wall_thickness))
    throw InputError(text("'Packing/stairs/Bearing' is ", text_to_copy(bearing),
                          ", more than 'Wall thickness', ",
                          text_to_copy(wall_thickness),
                          "; make it that or "
                          "less."));
  const double length = n_steps * going + overlap + 2. * wall_ends;
  check_number_of_cells((double(n_steps) + n_courses_above) *
                            (length / brick_length + 2.),
                        "'Packing/stairs/Steps', 'Going', 'Wall ends', "
                        "'Courses above' and 'Brick length'");
}

CellFaces StairsGenerator::generate(const std::filesystem::path &,
                                    Terminal &) const
{
  check();
  const bool goes_through = is_same_length(bearing, wall_thickness);
  const double end_of_steps = goes_through ? wall_thickness : bearing;
  const unsigned int n_courses = n_steps + n_courses_above;
  const auto front = [&](const unsigned int step) {
    return wall_ends + going * step;
  };
  const double length = front(n_steps) + overlap + wall_ends;
  WallElevation wall(
      {length,
       rise * n_courses,
       n_courses,
       brick_length,
       {{{0., length}, {0., length}}}},
      "The steps of 'Packing/stairs'",
      "change 'Going', 'Overlap', 'Wall ends' or 'Brick length'.");

  BlockBuilder blocks({"brick", "step"});
  const auto add = [&](const unsigned int course, const WallInterval &along,
                       const WallInterval &across, const unsigned int group) {
    blocks.add_box({along.left, across.left, wall.bed_joint(course)},
                   {along.right, across.right, wall.bed_joint(course + 1)},
                   group);
  };
  for (unsigned int k = 0; k < n_courses; ++k)
  {
    std::vector<WallPart> holes;
    if (k < n_steps)
      holes.push_back(
          {wall.snap(front(k)), wall.snap(front(k + 1) + overlap), k, k + 1});
    const RowPattern pattern =
        rows_of_course(WallBond::running, k, 1).front().pattern;
    for (const WallInterval &gap : divide_course(wall, k, holes, {}).gaps)
      for (const WallStone &stone : lay_row(wall, pattern, gap))
        add(k, {stone.left, stone.right}, {0., wall_thickness},
            brick_of_stairs);
    for (const WallPart &hole : holes)
    {
      const WallInterval along = {hole.left, hole.right};
      add(k, along, {-width, end_of_steps}, step_of_stairs);
      if (!goes_through)
        add(k, along, {end_of_steps, wall_thickness}, brick_of_stairs);
    }
  }
  return blocks.take();
}
} // namespace Voussoir
