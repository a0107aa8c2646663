// SPDX-License-Identifier: LGPL-2.1-or-later

// Joints of some width: blocks keep their shapes, and their interface is midway
// between sides that face each other, as far as these do.

#include "polygons.h"
#include "tests.h"

namespace test_joint_geometry
{
using namespace Voussoir;

void run()
{
  std::cout << "Two bricks with a joint of 0.1, shifted by a quarter"
            << std::endl;
  const Packing<2> bricks =
      joined({rectangle(0, 0, 2, 1), rectangle(0.5, 1.1, 2, 1)}, 0.1);
  const Packing<2>::Interface &bed = bricks.interfaces().at(0);
  check("one joint", bricks.interfaces().size() == 1);
  check_error("midway",
              bed.start.distance({2., 1.05}) + bed.end.distance({0.5, 1.05}),
              1e-15);
  check_error("areas", std::abs(bricks.area() - 4.), 1e-15);
  check("what does not face is free", bricks.boundary_edges().size() == 8);
  check_error("distance of the centres", std::abs(bricks.distance(bed) - 1.1),
              1e-15);
  check("a width below the gap joins nothing",
        joined({rectangle(0, 0, 2, 1), rectangle(0.5, 1.1, 2, 1)}, 0.099)
            .interfaces()
            .empty());

  std::cout << "A wedge that opens from 0 to 0.2, joined up to 0.1"
            << std::endl;
  const Packing<2> wedge =
      joined({rectangle(0, 0, 2, 1), {{0, 1}, {2, 1.2}, {2, 2}, {0, 2}}}, 0.1);
  const Packing<2>::Interface &half = wedge.interfaces().at(0);
  const double angle = 0.5 * std::atan(0.1);
  check_error("on the line that halves the angle",
              std::abs(half.normal[0] + std::sin(angle)) +
                  std::abs(half.normal[1] - std::cos(angle)),
              1e-15);
  check_error("as far as the width allows",
              std::abs(half.length - 0.05 / std::sin(angle) * std::cos(angle)),
              2e-9);
  check("not beyond the angle",
        joined({rectangle(0, 0, 2, 1), {{0, 1}, {2, 1.6}, {2, 2}, {0, 2}}}, 1.)
            .interfaces()
            .empty());

  std::cout << "A bent side: parts that overlap end midway" << std::endl;
  const Packing<2> bent = joined({{{0, 0}, {4, 0}, {4, 1}, {2, 1.2}, {0, 1}},
                                  {{0, 1.1}, {1.99, 1.3}, {0, 3}},
                                  {{2.01, 1.3}, {4, 1.1}, {4, 3}}},
                                 0.15);
  double length = 0.;
  for (const Packing<2>::Interface &i : bent.interfaces())
    length += i.length;
  check("two beds", bent.interfaces().size() == 2);
  check("as long as the bent side",
        length > 3.9 && length < 2. * std::hypot(2., 0.2));

  std::cout << "A thin stone in a wide joint" << std::endl;
  const Packing<2> thin =
      joined({rectangle(0, 0, 2, 1), rectangle(0, 1.02, 2, 0.05),
              rectangle(0, 1.1, 2, 1)},
             0.2);
  check("is joined to both others, and these are not",
        thin.interfaces().size() == 2 && thin.interfaces()[0].cell_plus == 1 &&
            thin.interfaces()[1].cell_minus == 1);
}

const RoomTest test("joint_geometry", run);
} // namespace test_joint_geometry
