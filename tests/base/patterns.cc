// SPDX-License-Identifier: LGPL-2.1-or-later

// What an entry accepts, in words, from deal.II's own descriptions.

#include <voussoir/base/parameters/pattern_description.h>

#include <deal.II/base/patterns.h>

#include "room.h"
#include <iostream>

namespace test_patterns
{
void run()
{
  using namespace dealii::Patterns;
  const auto show = [](const PatternBase &pattern) {
    std::cout << Voussoir::text_of_pattern(pattern.description()) << '\n';
  };
  show(Anything());
  show(Bool());
  show(Double());
  show(Double(0.));
  show(Double(1e-14, 1e-2));
  show(Double(-std::numeric_limits<double>::max(), 3.));
  show(Integer());
  show(Integer(1));
  show(Integer(0, 2));
  show(Selection("least energy|linear program"));
  show(List(Anything(), 2, 2, ";"));
  show(List(Double(), 0));
  show(List(Double(), 2));
  show(List(List(Double(), 2, 2, ","), 1, 3, ";"));
  show(DirectoryName()); // not in use: as deal.II says it
}

const RoomTest test("patterns", run);
} // namespace test_patterns
