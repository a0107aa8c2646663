// SPDX-License-Identifier: LGPL-2.1-or-later

// Barrel vaults against the arch of the plane and closed forms: numbers of
// blocks, volumes, areas of joints, groups, the springings; failures.

#include <voussoir/packing/polyhedra/generators/vault.h>

#include "shell_checks.h"

namespace test_space_vault
{
using namespace Voussoir;
using dealii::numbers::PI;

CellFaces generate(const std::string &settings)
{
  return generated<VaultGenerator>(settings);
}

/** The arch of the plane with the same settings. */
CellLoops arch(const std::string &settings)
{
  ArchGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.parse_input_from_string(settings);
  return generator.generate("", Terminal::silent());
}

bool is_across(const dealii::Point<3> &, const dealii::Tensor<1, 3> &normal)
{
  return std::abs(std::abs(normal[1]) - 1.) < 1e-9;
}

/**
 * A vault 3 long with n blocks in a row. Every bed of a running bond has 2n
 * patches, as that of a wall has.
 */
void check_vault(const std::string &what,
                 const std::string &arch_settings,
                 const std::string &bond,
                 const unsigned int n)
{
  std::cout << what << ", " << n << " in a row, " << bond << std::endl;
  const CellFaces cells =
      generate(text(arch_settings, "set Length = 3\nset Blocks per row = ", n,
                    "\nset Bond = ", bond));
  const Packing<2> plane(arch(arch_settings));
  const unsigned int n_rows = plane.n_cells();
  const bool shifted = bond == "running";
  const unsigned int n_cells = n_rows * n + (shifted ? n_rows / 2 : 0);
  check("  cells", cells.n_cells() == n_cells);
  check_shell(cells, plane.area() * 3., 0);

  double beds = 0., heads = 0.;
  for (const auto &joint : plane.interfaces())
    beds += joint.length * 3.;
  for (unsigned int row = 0; row < n_rows; ++row)
    heads += plane.area(row) * (n - 1 + (shifted ? row % 2 : 0));
  const ContactAreas areas = contact_areas(cells, is_across);
  check("  pairs that touch",
        areas.n_pairs ==
            n_cells - n_rows + (n_rows - 1) * n * (shifted ? 2 : 1));
  check_area("  beds", areas.beds, beds);
  check_area("  heads", areas.heads, heads);
}

/** Groups row by row, and the places of the blocks of a row. */
void check_order()
{
  const std::string settings = "set Voussoirs = 5\nset Abutments = 2\n";
  const CellLoops plane = arch(settings);
  const CellFaces cells =
      generate(settings + "set Length = 4\nset Blocks per row = 2\n");
  const std::vector<Box3> boxes = boxes_of(cells);
  bool named = true, in_order = true;
  unsigned int c = 0;
  for (unsigned int row = 0; row < plane.n_cells(); ++row)
  {
    const std::vector<double> joints =
        row % 2 == 0 ? std::vector<double>{0., 2., 4.}
                     : std::vector<double>{0., 1., 3., 4.};
    for (unsigned int k = 0; k + 1 < joints.size(); ++k, ++c)
    {
      named &= cells.group_names[cells.group[c]] ==
               plane.group_names[plane.group[row]];
      in_order &= boxes[c].lower_bound(1) == joints[k] &&
                  boxes[c].upper_bound(1) == joints[k + 1];
    }
  }
  check("  all cells", c == cells.n_cells());
  check("  groups of the arch", named);
  check("  order of the cells", in_order);
  const std::map<std::string, unsigned int> expected = {
      {"voussoir", 10}, {"keystone", 2}, {"abutment", 10}};
  check("  sizes of the groups", group_sizes(cells) == expected);
}

/** Two rings: blocks overlap along each of them, and from one to the other. */
void check_rings()
{
  const std::string settings =
      "set Voussoirs = 5\nset Abutments = 1\nset Rings = 2\n"
      "set Abutment width = 0.7\n";
  const CellLoops plane = arch(settings);
  const CellFaces cells =
      generate(settings + "set Length = 3\nset Blocks per row = 2\n");
  check_shell(cells, Packing<2>(plane).area() * 3., 0);
  // Piers of two blocks, and at each place a row of two and one of three.
  std::vector<unsigned int> in_row = {2};
  for (unsigned int place = 0; place < 5; ++place)
    for (const unsigned int ring : {0, 1})
      in_row.push_back((place + ring) % 2 == 0 ? 3 : 2);
  in_row.push_back(2);
  std::vector<unsigned int> groups;
  for (unsigned int row = 0; row < plane.n_cells(); ++row)
    groups.insert(groups.end(), in_row.at(row), plane.group[row]);
  check("  rows of two and of three in turn", cells.group == groups);
}

void refuse(const std::string &settings)
{
  show_refusal([&] { generate(settings); });
}

void run()
{
  const std::string half = "set Mean radius = 2\nset Thickness = 0.5\n"
                           "set Voussoirs = 11\n";
  check_vault("semicircle", half, "running", 4);
  check_vault("semicircle", half, "stack", 4);
  check_vault("semicircle", half, "running", 1);
  check_vault("segment", half + "set Embrace = 100\n", "running", 3);
  check_vault("segment on piers",
              half + "set Embrace = 100\nset Abutments = 3\n", "running", 3);
  check_vault("pointed", "set Shape = pointed\nset Voussoirs = 13\n", "running",
              3);
  check_vault("pointed", "set Shape = pointed\nset Voussoirs = 12\n", "stack",
              3);

  std::cout << "arch of n trapezoids" << std::endl;
  const CellFaces cells = generate("set Bond = stack\nset Blocks per row = 1\n"
                                   "set Length = 0.5\nset Voussoirs = 20\n");
  check("  cells", cells.n_cells() == 20);
  check_area("  volume", volume_of(cells), 20. * std::sin(PI / 20.) * 0.1);
  check_area("  springings at z = 0", area_on_ground(cells), 2. * 0.2 * 0.5);

  std::cout << "in millimetres" << std::endl;
  const CellFaces large = generate(
      "set Mean radius = 5000\nset Thickness = 300\nset Length = 12000\n");
  check_shell(large, 15. * std::sin(PI / 15.) * 5000. * 300. * 12000., 0);

  std::cout << "order" << std::endl;
  check_order();

  std::cout << "two rings on wide piers" << std::endl;
  check_rings();

  refuse("set Length = 0");
  refuse("set Thickness = 0");
  refuse("set Abutments = 1\nset Abutment height = 0");
  refuse("set Thickness = 2");
  refuse("set Shape = pointed\nset Thickness = 0.5\nset Voussoirs = 21");
  refuse("set Shape = pointed\nset Thickness = 2");
  refuse("set Voussoirs = 1000000\nset Blocks per row = 1000");
  refuse("set Thickness = 1e-9");
  refuse("set Length = 1\nset Blocks per row = 600000");
}

const RoomTest test("space_vault", run);
} // namespace test_space_vault
