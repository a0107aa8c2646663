// SPDX-License-Identifier: LGPL-2.1-or-later

// Groups of cells by conditions on their centres; names that cannot be used.

#include <voussoir/packing/cell_groups.h>
#include <voussoir/packing/group_names.h>

#include "tests.h"

namespace test_cell_groups
{
using namespace Voussoir;

void run()
{
  Packing<2> packing = wall(4, 3);
  const unsigned int ground = packing.ground();
  check("the ground is a group of its own",
        packing.group_name(ground) == "ground" &&
            packing.group_names().back() == "ground");
  assign_groups(packing, "low: y < 0.5; left stones: x < 0.2; low : y < 0.25");
  bool right = true;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    const auto &x = packing.centre(c);
    const std::string expected = x[1] < 0.25  ? "low"
                                 : x[0] < 0.2 ? "left stones"
                                 : x[1] < 0.5 ? "low"
                                              : "brick";
    right &= packing.group_name(c) == expected;
  }
  check("the last condition that a cell meets counts", right);
  check("the ground is still the last group",
        packing.group(ground) == packing.group_names().size() - 1 &&
            packing.group_name(ground) == "ground");
  check("a name in another script",
        fault_of_group_name("Gew\u00f6lbe").empty());

  for (const std::string name :
       {"ground", "cell 3", "cell3", "a,b", "a\"b", "tab\tname", "caf\xe9"})
    show_refusal([&] { assign_groups(packing, name + ": 1"); });
  const std::string zeros(1000000, '0');
  check("a cell with many digits",
        fault_of_group_name("cell" + zeros) == fault_of_group_name("cell 3") &&
            cells_of_name(packing, "cell  " + zeros + "7", "Test") ==
                std::vector<unsigned int>{7});
  show_refusal([&] { cells_of_name(packing, "cell 99", "Test"); });
  show_refusal([&] { cells_of_name(packing, "cell99", "Test"); });
  show_refusal([&] { check_group_name("a:b"); });
  show_refusal([&] { check_group_name("a;b"); });
  show_refusal([&] { check_group_name(std::string("a\0b", 3)); });
  show_refusal([&] { check_group_name(""); });
  show_refusal([&] { assign_groups(packing, "high: y > 2"); });
  show_refusal([&] { assign_groups(packing, "high: y >"); });
  show_refusal([&] { assign_groups(packing, "high"); });
  show_refusal([&] { assign_groups(packing, "high: log(-y)"); });
}

const RoomTest test("cell_groups", run);
} // namespace test_cell_groups
