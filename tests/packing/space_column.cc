// SPDX-License-Identifier: LGPL-2.1-or-later

// Columns of drums: numbers, volumes and heights in closed form, drums that
// share their sections to the last bit, architraves; failures.

#include <voussoir/packing/polyhedra/generators/column.h>

#include <deal.II/base/numbers.h>

#include "block_checks.h"

namespace test_space_column
{
using namespace Voussoir;

CellFaces generate(const std::string &settings)
{
  return generated<ColumnGenerator>(settings);
}

/** The area of a regular polygon in a circle of radius 1. */
double unit_area(const unsigned int n_sides)
{
  return n_sides / 2. * std::sin(2. * dealii::numbers::PI / n_sides);
}

/** The faces of a cell that look up, or down. */
std::vector<dealii::Point<3>>
end_of(const CellFaces &cells, const unsigned int cell, const bool up)
{
  for (unsigned int f = cells.first_face[cell]; f < cells.first_face[cell + 1];
       ++f)
  {
    auto polygon = cells.polygon(f);
    const auto normal = moments_of(dealii::make_array_view(polygon)).normal();
    if (up ? normal[2] > 0.999 : normal[2] < -0.999)
    {
      std::sort(
          polygon.begin(), polygon.end(), [](const auto &a, const auto &b) {
            return std::make_pair(a[0], a[1]) < std::make_pair(b[0], b[1]);
          });
      return polygon;
    }
  }
  return {};
}

double area_of(std::vector<dealii::Point<3>> polygon,
               const dealii::Point<3> &around)
{
  std::sort(polygon.begin(), polygon.end(), [&](const auto &a, const auto &b) {
    return std::atan2(a[1] - around[1], a[0] - around[0]) <
           std::atan2(b[1] - around[1], b[0] - around[0]);
  });
  return moments_of(dealii::make_array_view(polygon)).area();
}

void check_column(const unsigned int n_drums,
                  const unsigned int n_sides,
                  const double bottom,
                  const double top)
{
  std::cout << n_drums << " drums of " << n_sides << " sides" << std::endl;
  const double height = 4.7;
  const CellFaces cells =
      generate(text("set Drums = ", n_drums, "\nset Sides = ", n_sides,
                    "\nset Bottom radius = ", bottom,
                    "\nset Top radius = ", top, "\nset Height = ", height));
  check("  cells", cells.n_cells() == n_drums &&
                       cells.n_faces() == n_drums * (n_sides + 2));
  check_blocks(cells, unit_area(n_sides) * height *
                          (bottom * bottom + bottom * top + top * top) / 3.);
  bool joined = true;
  double error = 0., sections = 0.;
  for (unsigned int k = 0; k + 1 < n_drums; ++k)
  {
    const auto below = end_of(cells, k, true);
    joined &= below.size() == n_sides && below == end_of(cells, k + 1, false);
    const double radius = bottom + (top - bottom) * (k + 1) / n_drums;
    sections += unit_area(n_sides) * radius * radius;
    error =
        std::max(error, std::abs(area_of(below, {0., 0., below[0][2]}) /
                                     (unit_area(n_sides) * radius * radius) -
                                 1.));
  }
  check("  drums share their sections", joined);
  check_error("  areas of the sections", error, 1e-13);
  const auto areas = areas_of_contacts(cells);
  check_error("  areas of contacts", std::abs(areas[2] - sections), 1e-12);
  check_error("  only at beds", areas[0] + areas[1], 0.);
  const Box3 box(cells.vertices);
  check_error("  height", std::abs(box.upper_bound(2) - height), 1e-15);
  const double reach =
      std::max(bottom, top) * std::cos(dealii::numbers::PI / n_sides);
  check_error("  a side faces x", std::abs(box.upper_bound(0) - reach), 1e-15);
}

void check_row()
{
  std::cout << "three columns with an architrave" << std::endl;
  const CellFaces cells = generate(
      "set Columns = 3\nset Spacing = 2.3\nset Drums = 5\nset Sides = 4\n"
      "set Bottom radius = 0.4\nset Top radius = 0.3\nset Height = 3\n"
      "set Plinth width = 1.1\nset Plinth height = 0.3\n"
      "set Capital width = 0.9\nset Capital height = 0.2\n"
      "set Architrave width = 0.7\nset Architrave height = 0.5");
  check("  groups", group_sizes(cells) ==
                        std::map<std::string, unsigned int>{{"drum", 15},
                                                            {"plinth", 3},
                                                            {"capital", 3},
                                                            {"architrave", 2}});
  const double drums = 2. * 3. * (0.16 + 0.12 + 0.09) / 3.;
  check_blocks(cells, 3. * (drums + 1.1 * 1.1 * 0.3 + 0.9 * 0.9 * 0.2) +
                          (2. * 2.3 + 0.9) * 0.7 * 0.5);
  const std::vector<Box3> boxes = boxes_of(cells);
  check("  order", cells.group_names[cells.group[0]] == "plinth" &&
                       cells.group_names[cells.group[6]] == "capital" &&
                       cells.group_names[cells.group[7]] == "plinth" &&
                       cells.group_names[cells.group[21]] == "architrave");
  bool stacked = true;
  for (unsigned int c = 0; c < 21; ++c)
    stacked &= c % 7 == 0
                   ? boxes[c].lower_bound(2) == 0.
                   : boxes[c].lower_bound(2) == boxes[c - 1].upper_bound(2);
  check("  each block on the one below",
        stacked && boxes[21].lower_bound(2) == boxes[20].upper_bound(2) &&
            boxes[22].lower_bound(2) == boxes[6].upper_bound(2));
  // Between drums, drums and slabs, and beams; the top of a capital carries
  // beams over its width, and two beams meet.
  const auto areas = areas_of_contacts(cells);
  double joints = 0.;
  for (unsigned int k = 0; k <= 5; ++k)
    joints += 3. * 2. * std::pow(0.4 - 0.02 * k, 2);
  check_error("  beds", std::abs(areas[2] - joints - 3. * 0.9 * 0.7), 1e-12);
  check_error("  between the beams", std::abs(areas[0] - 0.7 * 0.5), 1e-15);
  check("  no overlaps", overlaps(cells, cells.tolerance).empty());
  check("  beams meet above the axis",
        boxes[21].upper_bound(0) == boxes[22].lower_bound(0) &&
            boxes[21].upper_bound(0) == 2.3);
  check("  beams end with the capitals",
        boxes[21].lower_bound(0) == boxes[6].lower_bound(0) &&
            boxes[22].upper_bound(0) == boxes[20].upper_bound(0));
}

void refuse(const std::string &settings)
{
  show_refusal([&] { generate(settings); });
}

void run()
{
  check_column(1, 3, 1., 1.);
  check_column(7, 4, 0.5, 0.5);
  check_column(8, 12, 0.4, 0.35);
  check_column(3, 31, 0.2, 0.9);
  check_row();
  // Without a capital the outer beams end with the circle of the top drum.
  const CellFaces bare =
      generate("set Columns = 2\nset Spacing = 3\nset Architrave height = 1");
  check("beams without capitals",
        Box3(bare.vertices).lower_bound(2) == 0. &&
            boxes_of(bare).back().lower_bound(0) == -0.35 &&
            boxes_of(bare).back().upper_bound(0) == 3.35 &&
            boxes_of(bare).back().lower_bound(2) ==
                boxes_of(bare)[7].upper_bound(2));

  refuse("set Height = 0");
  refuse("set Top radius = 0");
  refuse("set Plinth height = 0.2\nset Plinth width = 0");
  refuse("set Columns = 2\nset Spacing = 0");
  refuse("set Columns = 2\nset Spacing = 0.7");
  refuse("set Columns = 2\nset Spacing = 1\nset Capital height = 0.1\n"
         "set Capital width = 1.2");
  refuse("set Architrave height = 0.5");
  refuse("set Columns = 100000\nset Spacing = 1\nset Drums = 1000");
}

const RoomTest test("space_column", run);
} // namespace test_space_column
