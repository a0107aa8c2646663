// SPDX-License-Identifier: LGPL-2.1-or-later

// Running bond walls against counts in closed form. With n bricks a course,
// odd courses (the first among them) have n bricks and even ones n+1; every
// bed between two courses has 2n interfaces, for its halves alternate between
// the bricks.

#include "tests.h"

using namespace Voussoir;

void check_wall(const unsigned int courses, const unsigned int bricks)
{
  const double width = 3., height = 0.5;
  const Packing packing = wall(courses, bricks, width, height);
  const unsigned int even = courses / 2, odd = courses - even;
  const unsigned int top = courses % 2 == 1 ? bricks : bricks + 1;

  std::cout << courses << " courses of " << bricks << " bricks" << std::endl;
  check("  cells", packing.n_cells() == odd * bricks + even * (bricks + 1));
  check("  interfaces",
        packing.interfaces().size() ==
            odd * (bricks - 1) + even * bricks + (courses - 1) * 2 * bricks);
  check("  boundary edges",
        packing.boundary_edges().size() == bricks + top + 2 * courses);
  check_error("  area", std::abs(packing.area() - width * height), 1e-14);

  const double brick = width * height / (courses * bricks);
  double error = 0.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    error = std::max(error, std::min(std::abs(packing.area(c) - brick),
                                     std::abs(packing.area(c) - brick / 2)) /
                                brick);
  check_error("  whole and half bricks", error, 1e-13);
}

int main()
{
  check_wall(1, 1);
  check_wall(2, 1);
  check_wall(3, 2);
  check_wall(12, 6);
  check_wall(7, 40);
}
