// SPDX-License-Identifier: LGPL-2.1-or-later

// Writes pages of packings in space whose every number is known, for
// check_space_pages.py.

#include <voussoir/base/exceptions.h>
#include <voussoir/output/report/space_report.h>
#include <voussoir/packing/polyhedra/cell_moments.h>

#include <deal.II/base/exceptions.h>

#include "boxes.h"
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>

using namespace Voussoir;

namespace
{
/** The numbers of cells as a field. */
SpaceField numbers(const CellFaces &cells)
{
  SpaceField field = {"Number", "", std::vector<double>(cells.n_cells())};
  std::iota(field.values.begin(), field.values.end(), 0.);
  return field;
}

/** A wall on a slab: each field has its value in closed form. */
void write_wall(std::ostream &out)
{
  const std::vector<Box> list = wall_on_slab(6, 4);
  CellFaces cells = boxes(list);
  cells.n_fixed = 1;
  cells.group_names = {"bricks", "slab"};
  cells.group.assign(cells.n_cells(), 0);
  cells.group.back() = 1;
  const FaceContacts contacts = contacts_of(list);
  SpaceField height = {"Height", "m", {}}, force = {"Normal force", "kN", {}};
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
    height.values.push_back(moments_of(cells, c).centroid[2]);
  for (unsigned int j = 0; j < contacts.faces.size(); ++j)
    force.values.push_back(j == 3 ? std::numeric_limits<double>::infinity()
                                  : -1. * j);
  std::vector<CellDefect> defects;
  for (unsigned int k = 0; k < 13; ++k)
    defects.push_back({7,
                       "faces listed <twice>",
                       "taken once",
                       k,
                       1,
                       k % 6,
                       0.1 * k,
                       {},
                       ""});
  write_space_report(out, {"A <wall> & \"more\"",
                           &cells,
                           &contacts,
                           {numbers(cells), height},
                           {force},
                           {{"Blocks", "27 & 1"}, {"Tolerance", "1e-9 m"}},
                           {"Brick 3 is <thin>."},
                           defects});
}

/** Blocks that are not convex, one in the notch of the other. */
void write_notched(std::ostream &out)
{
  CellFaces cells;
  add_prism(cells,
            {{0., 0.}, {0., 3.}, {1., 3.}, {1., 1.}, {3., 1.}, {3., 0.}});
  add_prism(cells, {{1., 1.}, {1., 2.}, {2., 2.}, {2., 1.}});
  write_space_report(
      out, {"Notched", &cells, nullptr, {numbers(cells)}, {}, {}, {}});
}

void write_empty(std::ostream &out)
{
  const CellFaces cells;
  write_space_report(out, {"Nothing", &cells, nullptr, {}, {}, {}, {}});
}

/** More blocks than the picture takes, all of them apart. */
void write_many(std::ostream &out)
{
  std::vector<Box> list;
  for (unsigned int k = 0; k < 6000; ++k)
  {
    const dealii::Point<3> low(k % 20, k / 20 % 20, k / 400);
    list.push_back(
        box_between(low, low + dealii::Tensor<1, 3>({0.8, 0.8, 0.8})));
  }
  const CellFaces cells = boxes(list);
  write_space_report(out,
                     {"Many", &cells, nullptr, {numbers(cells)}, {}, {}, {}});
}
} // namespace

int main(int argc, char **argv)
{
  AssertThrow(argc == 2, dealii::ExcMessage("write_space_pages DIRECTORY"));
  const std::filesystem::path directory = argv[1];
  std::filesystem::create_directories(directory);
  for (const auto &[name, write] :
       {std::pair<std::string, void (*)(std::ostream &)>("wall", write_wall),
        {"notched", write_notched},
        {"empty", write_empty},
        {"many", write_many}})
  {
    std::ofstream out(directory / (name + ".html"));
    write(out);
    AssertThrow(out, dealii::ExcMessage("cannot write " + name));
  }
}
