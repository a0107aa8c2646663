// SPDX-License-Identifier: LGPL-2.1-or-later

// Arches against closed forms: areas, perimeters, joints on the middle line,
// mirror images to the last bit, piers and skewbacks, rings; failures.

#include <voussoir/base/text.h>
#include <voussoir/packing/generators/arch.h>

#include "tests.h"

namespace test_arch
{
using namespace Voussoir;
using dealii::numbers::PI;

CellLoops generate(const std::string &settings)
{
  ArchGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.parse_input_from_string(settings);
  return generator.generate("", Terminal::silent());
}

/** Cells c and n-1-c are mirror images; the groups are named as expected. */
void check_arch(const CellLoops &cells,
                const unsigned int n_voussoirs,
                const unsigned int n_courses)
{
  const Packing<2> packing(cells);
  const unsigned int n = packing.n_cells();
  check("  cells", n == n_voussoirs + 2 * n_courses);
  check("  one interface from cell to cell, in order",
        packing.interfaces().size() == n - 1 &&
            std::all_of(packing.interfaces().begin(),
                        packing.interfaces().end(),
                        [](const Packing<2>::Interface &i) {
                          return i.cell_plus == i.cell_minus + 1;
                        }));
  bool mirrored = true, named = true;
  for (unsigned int c = 0; c < n; ++c)
  {
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
    {
      const auto p = packing.vertex(c, i);
      bool found = false;
      for (unsigned int j = 0; j < packing.n_sides(n - 1 - c); ++j)
        found |= packing.vertex(n - 1 - c, j) == dealii::Point<2>(-p[0], p[1]);
      mirrored &= found;
    }
    const bool in_pier = c < n_courses || n - 1 - c < n_courses;
    const bool is_key = n_voussoirs % 2 == 1 && 2 * c + 1 == n;
    named &= cells.group_names[cells.group[c]] ==
             (in_pier ? "abutment" : (is_key ? "keystone" : "voussoir"));
  }
  check("  symmetric to the last bit", mirrored);
  check("  groups", named);
}

double boundary_length(const Packing<2> &packing)
{
  double length = 0.;
  for (const auto &edge : packing.boundary_edges())
    length += edge.length;
  return length;
}

/** R = 2, t = 0.5; n trapezoids of angle E/n. */
void check_circular(const unsigned int n, const double embrace)
{
  std::cout << n << " voussoirs over " << embrace << " degrees" << std::endl;
  const CellLoops cells =
      generate(text("set Mean radius = 2\nset Thickness = 0.5\n"
                    "set Voussoirs = ",
                    n, "\nset Embrace = ", embrace));
  check_arch(cells, n, 0);
  const Packing<2> packing(cells);
  const double angle = embrace / 180. * PI / n;
  check_error("  area n sin(E/n) R t",
              std::abs(packing.area() - n * std::sin(angle) * 2. * 0.5), 1e-13);
  check_error("  perimeter 4 n sin(E/2n) R + 2 t",
              std::abs(boundary_length(packing) -
                       4. * n * std::sin(angle / 2.) * 2. - 1.),
              1e-12);
  double error = 0.;
  for (const auto &i : packing.interfaces())
    error =
        std::max({error, std::abs(i.midpoint().norm() - 2.),
                  std::abs(i.length - 0.5), std::abs(i.normal * i.midpoint())});
  check_error("  joints on radii, halved by the middle line", error, 1e-14);
}

/** Span 4, t = 0.5, arcs of radius 4 k around (-+(4k - 2), 0). */
void check_pointed(const unsigned int n, const double ratio)
{
  std::cout << "pointed, " << n << " voussoirs, radius over span " << ratio
            << std::endl;
  const CellLoops cells =
      generate(text("set Shape = pointed\nset Span = 4\nset Thickness = 0.5\n"
                    "set Voussoirs = ",
                    n, "\nset Radius over span = ", ratio));
  check_arch(cells, n, 0);
  const Packing<2> packing(cells);
  const double radius = 4. * ratio, offset = radius - 2.;
  const double half_angle = std::acos(offset / radius);

  // The joints of the left half, less that at the crown, at equal angles.
  double error = 0.;
  for (unsigned int k = 1; 2 * k < n; ++k)
  {
    const auto &i = packing.interfaces()[k - 1];
    const auto arm = i.midpoint() - dealii::Point<2>(offset, 0.);
    error = std::max(
        {error, std::abs(arm.norm() - radius),
         std::abs(std::atan2(arm[1], -arm[0]) - 2. * half_angle * k / n),
         std::abs(i.length - 0.5), std::abs(i.normal * arm)});
  }
  check_error("  joints on radii, at equal angles", error, 1e-13);

  const double trapezoid = std::sin(2. * half_angle / n) * radius * 0.5;
  error = 0.;
  for (unsigned int c = 0; 2 * (c + 1) < n; ++c)
    error = std::max(error, std::abs(packing.area(c) - trapezoid));
  check_error("  equal voussoirs", error, 1e-13);
  double top = 0.;
  for (const auto &p : cells.vertices)
    top = std::max(top, p[1]);
  const double outer = radius + 0.25;
  check_error("  apex of the extrados",
              std::abs(top - std::sqrt(outer * outer - offset * offset)),
              1e-14);
}

/** Three courses, 1.5 high, under R = 2, t = 0.5; the pier is 0.5 wide. */
void check_piers(const double embrace)
{
  std::cout << "piers under " << embrace << " degrees" << std::endl;
  const CellLoops cells =
      generate(text("set Mean radius = 2\nset Thickness = 0.5\n"
                    "set Voussoirs = 9\nset Abutments = 3\n"
                    "set Abutment height = 1.5\nset Embrace = ",
                    embrace));
  check_arch(cells, 9, 3);
  const Packing<2> packing(cells);
  check_error("  courses of equal height",
              std::abs(packing.area(0) - 0.25) +
                  std::abs(packing.area(1) - 0.25),
              1e-14);
  // Above its inner face, the skewback is a rectangle as high as the joint,
  // less the triangle under the joint.
  const double half = embrace / 360. * PI;
  const double rise = 0.5 * std::cos(half), run = 0.5 * std::sin(half);
  check_error("  skewback",
              std::abs(packing.area(2) - 0.25 - rise * (0.5 - 0.5 * run)),
              1e-14);
  const double spring = 1.75 * std::cos(half);
  check_error("  bed at the foot",
              std::abs(packing.vertex(0, 0)[1] - (spring - 1.5)), 1e-14);
  const auto &bed = packing.interfaces()[1];
  check("  bed below the skewback horizontal", bed.normal[1] == 1.);
}

/** The length of the joints across an arch, without those of its piers. */
double length_across(const Packing<2> &packing, const bool with_keystone)
{
  double length = 0.;
  for (const auto &i : packing.interfaces())
  {
    const std::string &a = packing.group_name(i.cell_minus),
                      &b = packing.group_name(i.cell_plus);
    if (a != "abutment" && b != "abutment" && (with_keystone || a == b))
      length += i.length;
  }
  return length;
}

/** Each cell of one ring, R = 2 and t = 0.6, is one of each of several. */
void check_rings(const unsigned int n_rings,
                 const unsigned int n,
                 const std::string &shape)
{
  std::cout << n_rings << " rings of " << n << " voussoirs" << std::endl;
  const unsigned int n_courses = 2;
  const std::string settings =
      text(shape,
           "\nset Mean radius = 2\nset Span = 4\nset Thickness = 0.6\n"
           "set Abutments = 2\nset Voussoirs = ",
           n, "\n");
  const Packing<2> whole(generate(settings));
  const CellLoops cells = generate(text(settings, "set Rings = ", n_rings));
  const Packing<2> packing(cells);
  check("  cells", packing.n_cells() == n * n_rings + 2 * n_courses);
  check("  joints along the arch, across it, at its foot and in the piers",
        packing.interfaces().size() ==
            n * (n_rings - 1) + (n + 1) * n_rings + 2 * (n_courses - 1));

  double error = 0.;
  bool named = true, stacked = true;
  for (unsigned int k = 0; k < n; ++k)
  {
    double area = 0.;
    for (unsigned int r = 0; r < n_rings; ++r)
    {
      const unsigned int c = n_courses + k * n_rings + r;
      area += packing.area(c);
      named &= cells.group_names[cells.group[c]] == text("ring ", r + 1);
      stacked &=
          r == 0 || packing.centre(c).norm() > packing.centre(c - 1).norm();
    }
    error = std::max(error, std::abs(area - whole.area(n_courses + k)));
  }
  check_error("  areas", error, 1e-14);
  check("  named, from the inside to the outside", named && stacked);
  named = true;
  for (const unsigned int c : {0u, 1u, packing.n_cells() - 1})
    named &= cells.group_names[cells.group[c]] == "abutment";
  check("  piers are abutments", named);
  check_error(
      "  the joints across are whole",
      std::abs(length_across(packing, false) - length_across(whole, true)),
      1e-13);
  check_error("  and so is the outline",
              std::abs(boundary_length(packing) - boundary_length(whole)),
              1e-13);
}

/** The joint between rings k and k+1 of five, R = 2 and t = 0.5, is a chord. */
void check_chords()
{
  const unsigned int n = 12;
  const CellLoops cells =
      generate("set Mean radius = 2\nset Thickness = 0.5\nset Rings = 5\n"
               "set Embrace = 90\nset Voussoirs = 12");
  const Packing<2> packing(cells);
  double error = 0.;
  unsigned int n_chords = 0;
  for (const auto &i : packing.interfaces())
  {
    const unsigned int a = cells.group[i.cell_minus],
                       b = cells.group[i.cell_plus];
    if (a == b)
      continue;
    ++n_chords;
    const double radius = 1.75 + 0.1 * std::max(a, b);
    error = std::max(
        {error, std::abs(i.length - 2. * radius * std::sin(PI / 4. / n)),
         std::abs(i.midpoint().norm() - radius * std::cos(PI / 4. / n))});
  }
  check("chords between five rings", n_chords == 4 * n);
  check_error("  on circles", error, 1e-14);
}

/** Piers 1.2 wide and 1.5 high under R = 2, t = 0.5, as in check_piers(). */
void check_wide_piers(const double embrace)
{
  const CellLoops cells =
      generate(text("set Mean radius = 2\nset Thickness = 0.5\n"
                    "set Voussoirs = 9\nset Abutments = 3\n"
                    "set Abutment height = 1.5\nset Abutment width = 1.2\n"
                    "set Embrace = ",
                    embrace));
  std::cout << "wide piers under " << embrace << " degrees" << std::endl;
  check_arch(cells, 9, 3);
  const Packing<2> packing(cells);
  check_error("  courses of equal height",
              std::abs(packing.area(0) - 0.6) + std::abs(packing.area(1) - 0.6),
              1e-14);
  const double half = embrace / 360. * PI;
  const double rise = 0.5 * std::cos(half), run = 0.5 * std::sin(half);
  check_error("  skewback",
              std::abs(packing.area(2) - 0.6 - rise * (1.2 - 0.5 * run)),
              1e-14);
}

void refuse(const std::string &settings)
{
  show_refusal([&] { generate(settings); });
}

void run()
{
  check_circular(10, 180.);
  check_circular(15, 180.);
  check_circular(2, 180.);
  check_circular(7, 60.);
  check_circular(40, 123.4);
  bool level = true;
  for (const auto &cells :
       {generate("set Thickness = 0.3"), generate("set Shape = pointed")})
    for (const unsigned int v : {0, 1})
      level &= cells.vertices[v][1] == 0.;
  check("springings at y = 0", level);

  check_pointed(9, 1.);
  check_pointed(10, 1.);
  check_pointed(2, 0.8);
  check_pointed(15, 0.5);
  check_pointed(7, 3.);

  check_piers(180.);
  check_piers(120.);
  check_piers(30.);
  // The ledge would be 0.5 (1 - sin(85 degrees)) = 0.0019 wide.
  check("no ledge so narrow", Packing<2>(generate("set Thickness = 0.5\n"
                                                  "set Abutments = 1\n"
                                                  "set Embrace = 170"))
                                      .n_sides(0) == 4);

  check_wide_piers(180.);
  check_wide_piers(120.);

  check_rings(2, 9, "set Embrace = 130");
  check_rings(3, 10, "set Embrace = 180");
  check_rings(4, 9, "set Shape = pointed");
  check_rings(2, 10, "set Shape = pointed");
  check_chords();

  refuse("set Abutments = 1\nset Abutment width = 0.1");
  refuse("set Voussoirs = 1000000\nset Rings = 1000");
  refuse("set Thickness = 0");
  refuse("set Mean radius = 0");
  refuse("set Embrace = 0");
  refuse("set Shape = pointed\nset Span = 0");
  refuse("set Abutments = 2\nset Abutment height = 0");
  refuse("set Thickness = 2");
  refuse("set Shape = pointed\nset Thickness = 2");
  refuse("set Shape = pointed\nset Thickness = 0.5\nset Voussoirs = 21");
}

const RoomTest test("arch", run);
} // namespace test_arch
