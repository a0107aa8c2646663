// SPDX-License-Identifier: LGPL-2.1-or-later

// Walls of running bond against counts in closed form, and the overlap of the
// bonds. With n bricks a course, odd courses (the first among them) of a
// running bond have n bricks and even ones n+1; every bed between two courses
// has 2n interfaces, for its halves alternate between the bricks.

#include "tests.h"

namespace test_wall
{
using namespace Voussoir;

void check_running_bond(const unsigned int courses, const unsigned int bricks)
{
  const double width = 3., height = 0.5;
  const Packing<2> packing = wall(courses, bricks, width, height);
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

  // Cells course by course, from left to right, each from its lower left
  // corner.
  bool in_place = true;
  for (unsigned int course = 0, c = 0; course < courses; ++course)
    for (unsigned int b = 0; b < bricks + course % 2; ++b, ++c)
    {
      const unsigned int half = b == 0 ? 0 : 2 * b - course % 2;
      in_place &=
          packing.vertex(c, 0) == dealii::Point<2>(width * half / (2 * bricks),
                                                   height * course / courses);
    }
  check("  order of the cells", in_place);
}

/** Head joints by course, from the lengths of a wall whose courses are 1. */
std::vector<std::vector<double>> head_joints_of(const Packing<2> &packing)
{
  std::vector<std::vector<double>> joints;
  for (const auto &i : packing.interfaces())
    if (i.normal[0] == 1.)
    {
      const auto course = static_cast<unsigned int>(i.midpoint()[1]);
      joints.resize(std::max<std::size_t>(joints.size(), course + 1));
      joints[course].push_back(i.start[0]);
    }
  return joints;
}

unsigned int n_aligned(const std::vector<std::vector<double>> &joints)
{
  unsigned int n = 0;
  for (unsigned int k = 0; k + 1 < joints.size(); ++k)
    for (const double x : joints[k])
      n += std::count(joints[k + 1].begin(), joints[k + 1].end(), x);
  return n;
}

/** A wall in which a stretcher is 4 long and 1 high. */
Packing<2> bonded(const std::string &bond, const unsigned int n)
{
  WallGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.set("Bond", bond);
  prm.set("Courses", 5L);
  prm.set("Height", 5.);
  prm.set("Bricks per course", static_cast<long int>(n));
  prm.set("Width", 4. * n);
  return Packing<2>(generator.generate("", Terminal::silent()));
}

void check_bonds(const unsigned int n)
{
  std::cout << n << " stretchers" << std::endl;
  for (const std::string bond : {"running", "stack", "English", "Flemish"})
  {
    const Packing<2> packing = bonded(bond, n);
    const auto joints = head_joints_of(packing);
    double perimeter = 0., narrowest = 4., widest = 0.;
    for (const auto &edge : packing.boundary_edges())
      perimeter += edge.length;
    for (unsigned int c = 0; c < packing.n_cells(); ++c)
    {
      narrowest = std::min(narrowest, packing.area(c));
      widest = std::max(widest, packing.area(c));
    }
    check("  " + bond + ": area and perimeter",
          packing.area() == 20. * n && perimeter == 8. * n + 10.);
    check("    head joints above each other",
          n_aligned(joints) == (bond == "stack" ? 4 * (n - 1) : 0));
    check("    no brick shorter than a closer", narrowest >= 1.);
    check("    none longer than a stretcher", widest <= 4.);
  }

  // All headers of a Flemish bond but the outermost are centred over
  // stretchers; a right end that cuts the pattern is not looked at.
  const auto joints = head_joints_of(bonded("Flemish", n));
  bool centred = true;
  for (unsigned int k = 1; k < joints.size(); ++k)
    for (unsigned int j = 1; j + 1 < joints[k].size(); ++j)
      if (joints[k][j + 1] - joints[k][j] == 2.)
      {
        std::vector<double> below = joints[k - 1];
        below.insert(below.begin(), 0.);
        below.push_back(4. * n);
        const auto right =
            std::upper_bound(below.begin(), below.end(), joints[k][j]);
        centred &= *right == joints[k][j] + 3. &&
                   *std::prev(right) == joints[k][j] - 1.;
      }
  check("  Flemish headers centred over stretchers", centred);
}

void run()
{
  check_running_bond(1, 1);
  check_running_bond(2, 1);
  check_running_bond(3, 2);
  check_running_bond(12, 6);
  check_running_bond(7, 40);
  for (const unsigned int n : {1, 2, 3, 4, 5, 6, 7, 10, 12})
    check_bonds(n);

  // A symmetric English wall of 3 stretchers, and a Flemish one of 4.
  const std::vector<double> headers = {2, 3, 5, 7, 9, 10};
  check("English headers", head_joints_of(bonded("English", 3))[1] == headers);
  const std::vector<double> even = {4, 6, 10, 12}, odd = {2, 3, 7, 9, 13, 14};
  check("Flemish courses", head_joints_of(bonded("Flemish", 4))[0] == even &&
                               head_joints_of(bonded("Flemish", 4))[1] == odd);
}

const RoomTest test("wall", run);
} // namespace test_wall
