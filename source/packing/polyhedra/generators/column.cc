// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/generators/measures.h>
#include <voussoir/packing/polyhedra/generators/block_builder.h>
#include <voussoir/packing/polyhedra/generators/column.h>

#include <deal.II/base/numbers.h>

#include <algorithm>

namespace Voussoir
{
using dealii::Point;

namespace
{
/** The groups, in the order of their names. */
enum ColumnGroup : unsigned int
{
  drum,
  plinth,
  capital,
  architrave
};

/** The corners of a regular polygon in the unit circle, a side facing x. */
std::vector<Point<2>> unit_polygon(const unsigned int n_sides)
{
  std::vector<Point<2>> corners;
  for (unsigned int i = 0; i < n_sides; ++i)
  {
    const double angle = dealii::numbers::PI * (2. * i + 1.) / n_sides;
    corners.emplace_back(std::cos(angle), std::sin(angle));
  }
  return corners;
}

/** A section of a drum, around the axis through @p centre; lengths. */
BlockBuilder::Loop section_of_drum(const std::vector<Point<2>> &polygon,
                                   const Point<3> &centre,
                                   const double radius)
{
  BlockBuilder::Loop loop;
  for (const Point<2> &corner : polygon)
    loop.emplace_back(centre[0] + radius * corner[0], radius * corner[1],
                      centre[2]);
  return loop;
}

/** Add a box on a square around the axis at @p x; lengths. */
void add_slab(BlockBuilder &blocks,
              const double x,
              const double width,
              const std::array<double, 2> &heights,
              const ColumnGroup group)
{
  const double half = width / 2.;
  blocks.add_box({x - half, -half, heights[0]}, {x + half, half, heights[1]},
                 group);
}
} // namespace

void ColumnGenerator::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.add_parameter("Drums", n_drums, "Number of drums of a column.",
                    Integer(1, 1000000));
  prm.add_parameter("Sides", n_sides,
                    "Number of sides of a drum; 4 for square pillars.",
                    Integer(3, 10000));
  prm.add_parameter("Bottom radius", bottom_radius,
                    "Radius of the circle through the corners of a column at "
                    "its foot; a length, positive.",
                    Double(0.));
  prm.add_parameter("Top radius", top_radius,
                    "Radius of the circle through the corners of a column at "
                    "its top; a length, positive.",
                    Double(0.));
  prm.add_parameter("Height", height,
                    "Height of all drums of a column; a length, positive.",
                    Double(0.));
  prm.add_parameter("Plinth width", plinth_width,
                    "Width of the plinth below a column, along x and y; a "
                    "length, positive if there is a plinth.",
                    Double(0.));
  prm.add_parameter("Plinth height", plinth_height,
                    "Height of the plinth; a length, 0 for none.", Double(0.));
  prm.add_parameter("Capital width", capital_width,
                    "Width of the capital on a column, along x and y; a "
                    "length, positive if there is a capital.",
                    Double(0.));
  prm.add_parameter("Capital height", capital_height,
                    "Height of the capital; a length, 0 for none.", Double(0.));
  prm.add_parameter("Columns", n_columns, "Number of columns in a row.",
                    Integer(1, 1000000));
  prm.add_parameter("Spacing", spacing,
                    "Distance of the axes of two columns; a length, the width "
                    "of a column at least.",
                    Double(0.));
  prm.add_parameter("Architrave width", architrave_width,
                    "Width of the beams from column to column, along y; a "
                    "length, positive if there are beams.",
                    Double(0.));
  prm.add_parameter("Architrave height", architrave_height,
                    "Height of the beams; a length, 0 for none.", Double(0.));
}

void ColumnGenerator::check() const
{
  std::vector<Measure> measures = {{"Bottom radius", bottom_radius},
                                   {"Top radius", top_radius},
                                   {"Height", height}};
  const auto add_with = [&](const Measure &measure, const Measure &height) {
    if (height.value != 0.)
      measures.insert(measures.end(), {measure, height});
  };
  add_with({"Plinth width", plinth_width}, {"Plinth height", plinth_height});
  add_with({"Capital width", capital_width},
           {"Capital height", capital_height});
  add_with({"Architrave width", architrave_width},
           {"Architrave height", architrave_height});
  if (n_columns > 1)
    measures.push_back({"Spacing", spacing});
  check_measures("Packing/column", measures);
  // A side is a face as the four of a box and the two of its ends are.
  check_number_of_cells(double(n_columns) * (n_drums + 3.) *
                            std::max(1., n_sides / 4.),
                        "'Packing/column/Columns', 'Drums' and 'Sides'");

  double width = 2. * std::max(bottom_radius, top_radius);
  if (plinth_height > 0.)
    width = std::max(width, plinth_width);
  if (capital_height > 0.)
    width = std::max(width, capital_width);
  if (n_columns > 1 && spacing < width)
    throw InputError(text("'Packing/column/Spacing' is ", text_to_copy(spacing),
                          ", but a column is ", text_to_copy(width),
                          " wide; make it that at least."));
  if (architrave_height > 0. && n_columns == 1)
    throw InputError("'Packing/column/Architrave height' is " +
                     text(architrave_height) +
                     ", but there is one column; set it to 0, or 'Columns' to "
                     "2 or more.");
}

double ColumnGenerator::reach() const
{
  return capital_height > 0. ? capital_width / 2. : top_radius;
}

double ColumnGenerator::bed_joint(const unsigned int joint) const
{
  return plinth_height + height * joint / n_drums;
}

double ColumnGenerator::height_of_columns() const
{
  return bed_joint(n_drums) + capital_height;
}

CellFaces ColumnGenerator::generate(const std::filesystem::path &,
                                    Terminal &) const
{
  check();
  const std::vector<Point<2>> polygon = unit_polygon(n_sides);
  const auto section = [&](const unsigned int column,
                           const unsigned int joint) {
    const double top = double(joint) / n_drums;
    return section_of_drum(polygon, {spacing * column, 0., bed_joint(joint)},
                           (1. - top) * bottom_radius + top * top_radius);
  };

  BlockBuilder blocks({"drum", "plinth", "capital", "architrave"});
  for (unsigned int column = 0; column < n_columns; ++column)
  {
    const double x = spacing * column;
    if (plinth_height > 0.)
      add_slab(blocks, x, plinth_width, {{0., bed_joint(0)}}, plinth);
    for (unsigned int k = 0; k < n_drums; ++k)
      blocks.add_frustum(section(column, k), section(column, k + 1), drum);
    if (capital_height > 0.)
      add_slab(blocks, x, capital_width,
               {{bed_joint(n_drums), height_of_columns()}}, capital);
  }
  if (architrave_height > 0.)
    for (unsigned int beam = 0; beam + 1 < n_columns; ++beam)
    {
      const double left = beam == 0 ? -reach() : spacing * beam;
      const double right = beam + 2 == n_columns
                               ? spacing * (beam + 1) + reach()
                               : spacing * (beam + 1);
      blocks.add_box({left, -architrave_width / 2., height_of_columns()},
                     {right, architrave_width / 2.,
                      height_of_columns() + architrave_height},
                     architrave);
    }
  return blocks.take();
}
} // namespace Voussoir
