// SPDX-License-Identifier: LGPL-2.1-or-later

// Means over edges: tractions and strengths that are polynomials along an edge
// are averaged exactly; uniform stress gives S n; strengths of pairs of groups,
// body forces, forces on cells and loaded parts of the boundary; bad values are
// refused.

#include <voussoir/contact/friction_parameters.h>
#include <voussoir/packing/area_moments.h>
#include <voussoir/packing/cell_groups.h>
#include <voussoir/scene/loads/loads.h>
#include <voussoir/scene/supports.h>

#include "tests.h"

namespace test_loads_and_strengths
{
using namespace Voussoir;

Loads loads_on(const Packing<2> &packing, const std::string &settings)
{
  LoadParameters loads;
  dealii::ParameterHandler prm;
  loads.add_parameters(prm);
  prm.parse_input_from_string("subsection Loads\n" + settings + "\nend\n");
  return loads.loads(packing);
}

std::vector<double> strengths(const Packing<2> &packing,
                              const std::string &strength,
                              const std::string &pair_strengths = "")
{
  FrictionParameters friction;
  dealii::ParameterHandler prm;
  friction.add_parameters(prm);
  prm.parse_input_from_string(
      "subsection Friction\nset Strength = " + strength +
      "\nset Pair strengths = " + pair_strengths + "\nend\n");
  return friction.strengths(packing).of_interface;
}

/** The mean of x^2 over the edge from a to b. */
double mean_square(const double a, const double b)
{
  return (a * a + a * b + b * b) / 3.;
}

void run()
{
  const Packing<2> packing = random_packing(100, 1);

  const auto g =
      loads_on(packing, "set Traction = x^2 * nx; y^2 - ny").traction;
  double error = 0.;
  for (unsigned int b = 0; b < g.size(); ++b)
  {
    const auto &edge = packing.boundary_edges()[b];
    error =
        std::max({error,
                  std::abs(g[b][0] - mean_square(edge.start[0], edge.end[0]) *
                                         edge.normal[0]),
                  std::abs(g[b][1] - mean_square(edge.start[1], edge.end[1]) +
                           edge.normal[1])});
  }
  check_error("mean of a quadratic traction", error, 1e-14);

  const auto S_n = loads_on(packing, "set Boundary load = uniform stress\n"
                                     "set Stress = 1, 2; 2, -5")
                       .traction;
  error = 0.;
  for (unsigned int b = 0; b < S_n.size(); ++b)
    error = std::max(error, (S_n[b] - tensor(1, 2, 2, -5) *
                                          packing.boundary_edges()[b].normal)
                                .norm());
  check_error("uniform stress", error, 1e-15);

  const auto s = strengths(packing, "1 + x^2");
  error = 0.;
  for (unsigned int e = 0; e < s.size(); ++e)
    error =
        std::max(error, std::abs(s[e] - 1. -
                                 mean_square(packing.interfaces()[e].start[0],
                                             packing.interfaces()[e].end[0])));
  check_error("mean of a quadratic strength", error, 1e-14);

  const Packing<2> courses = wall(4, 3);
  const auto by_kind = strengths(courses, "abs(ny) > 0.5 ? 1 : 0.2");
  bool right = true;
  for (unsigned int e = 0; e < by_kind.size(); ++e)
  {
    const bool bed = courses.interfaces()[e].normal[1] > 0.5;
    right &= std::abs(by_kind[e] - (bed ? 1. : 0.2)) < 1e-15;
  }
  check("bed and head joints of different strength", right);

  Packing<2> courses_on_ground = wall(4, 3);
  courses_on_ground.support(
      boundary_edges_where(courses_on_ground, "ny < -0.5", "here"));
  assign_groups(courses_on_ground, "odd: floor(4*y) == 1; top: y > 0.75");
  const auto by_pair =
      strengths(courses_on_ground, "7",
                "brick, ground: 2; odd,brick : 3 + x; top, top: 0.5");
  right = true;
  for (unsigned int e = 0; e < by_pair.size(); ++e)
  {
    const auto &i = courses_on_ground.interfaces()[e];
    const double y = i.midpoint()[1];
    double expected = 7.;
    if (y == 0.)
      expected = 2.;
    else if (y == 0.25 || y == 0.5) // odd, the course from 0.25 to 0.5
      expected = 3. + i.midpoint()[0];
    else if (y > 0.75)
      expected = 0.5;
    right &= std::abs(by_pair[e] - expected) < 1e-15;
  }
  check("pairs of groups, the ground among them", right);

  // A body force that varies, against the moments of a polygon by Green's
  // formula; and a force on one cell, which its sub-cells share.
  const Loads inside =
      loads_on(packing, "set Body force = x; 1 - y\n"
                        "set Cell forces = cell 7: 3, -4; block: 0.5, 0");
  error = 0.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    double Ix = 0., Iy = 0.;
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
    {
      const auto &a = packing.vertex(c, i), &b = packing.vertex(c, i + 1);
      const double cross = a[0] * b[1] - a[1] * b[0];
      Ix += cross * (a[0] + b[0]) / 6.;
      Iy += cross * (a[1] + b[1]) / 6.;
    }
    const auto F = inside.body.force(packing, c);
    error = std::max(
        {error, std::abs(F[0] - Ix), std::abs(F[1] - packing.area(c) + Iy)});
  }
  check_error("integrals of a linear body force", error, 1e-15);
  check("forces on cells by number and by group",
        inside.on_cells[0].cells == std::vector<unsigned int>{7} &&
            inside.on_cells[0].force[1] == -4. &&
            inside.on_cells[1].cells.size() == packing.n_cells());
  // Body forces of groups, cell by cell, constant and not.
  {
    Packing<2> named = wall(4, 3);
    assign_groups(named, "odd: floor(4*y) == 1 | top: y > 0.75 || y < 0");
    const Loads of_groups =
        loads_on(named, "set Body force = 1; 0\n"
                        "set Group body forces = odd: 0; x < 9 ? -24 : 1 | "
                        "top: x; -y | cell 0: 0; 5");
    error = 0.;
    for (unsigned int c = 0; c < named.n_cells(); ++c)
    {
      const dealii::Point<2> &x = named.centre(c);
      dealii::Tensor<1, 2> b({1., 0.});
      if (c == 0)
        b = dealii::Tensor<1, 2>({0., 5.});
      else if (named.group_name(c) == "odd")
        b = dealii::Tensor<1, 2>({0., -24.});
      else if (named.group_name(c) == "top")
        b = dealii::Tensor<1, 2>({x[0], -x[1]});
      error = std::max(
          error, (of_groups.body.force(named, c) - named.area(c) * b).norm());
    }
    check_error("body forces of groups", error, 1e-14);
    check("semicolons between names, too",
          loads_on(named, "set Group body forces = odd: 0; -24; top: 1; 2")
                  .body.force(named, 0)
                  .norm() == 0.);
    show_refusal([&] { loads_on(named, "set Group body forces = odd: -24"); });
    show_refusal(
        [&] { loads_on(named, "set Group body forces = ground: 0; -24"); });
    show_refusal([&] {
      loads_on(named, "set Group body forces = odd: 0; 1 | odd: 0; 2");
    });
    show_refusal(
        [&] { loads_on(named, "set Group body forces = fill: 0; -24"); });
  }

  // Where x_c is not the centroid: a force evenly on a cell, or at a place in
  // it, and its torque about x_c.
  Packing<2> held = packing;
  held.support(std::vector<bool>(packing.boundary_edges().size(), true));
  const std::vector<double> ones(held.interfaces().size(), 1.);
  const dealii::Tensor<1, 2> f({3., -4.});
  error = 0.;
  for (unsigned int c = 0; c < held.n_cells(); ++c)
  {
    const dealii::Point<2> centroid =
        held.centre(c) + area_moments(held, c).centroid();
    for (const bool evenly : {true, false})
    {
      Loads one = loads_on(held, "");
      one.on_cells = {{"one", {c}, f, held.vertex(c, 0)}};
      if (evenly)
        one.on_cells[0].place.reset();
      const Scene scene(held, ones, one, rotations());
      const dealii::Point<2> x = evenly ? centroid : held.vertex(c, 0);
      error = std::max(
          {error, (scene.load[c] - f).norm(),
           std::abs(scene.load_torque[c] - cross(x - held.centre(c), f))});
    }
  }
  check_error("forces off the centroid, and their torques", error, 1e-14);

  // What was asked for goes with the loads, also into those that begin empty.
  Loads sum = no_loads(packing);
  sum.add(-2., loads_on(packing, "set Cell forces = at 0.31, 0.42: 3, -4\n"
                                 "set Boundary load = uniform stress\n"
                                 "set Stress = -1, 0; 0, -1"));
  check("what was asked for",
        sum.requested && (sum.requested->force() + 2. * f).norm() < 1e-14);

  // Point loads by place: within a cell, on its boundary, where cells touch.
  {
    const Packing<2> blocks = wall(2, 1, 3., 2.);
    const auto torque_about = [&](const CellForce &f,
                                  const dealii::Point<2> &x) {
      const unsigned int c = f.cells[0];
      return cross(blocks.centre(c) - x, f.force) + f.torque(blocks, c);
    };
    for (const auto &[place, x, n] :
         {std::make_tuple("0.25, 1.5", dealii::Point<2>(0.25, 1.5), 1u),
          std::make_tuple("2.5, 2", dealii::Point<2>(2.5, 2.), 1u),
          std::make_tuple("1.5, 2", dealii::Point<2>(1.5, 2.), 2u)})
    {
      const auto forces =
          loads_on(blocks,
                   std::string("set Cell forces = at ") + place + ": 3, -4")
              .on_cells;
      dealii::Tensor<1, 2> sum;
      double torque = 0.;
      for (const CellForce &f : forces)
      {
        sum += f.force;
        torque += torque_about(f, x);
      }
      check(std::string("a force at ") + place,
            forces.size() == n && sum[0] == 3. && sum[1] == -4. &&
                std::abs(torque) < 1e-15);
    }
    show_refusal(
        [&] { loads_on(blocks, "set Cell forces = at 1.5, 2.01: 0, -1"); });
    show_refusal([&] { loads_on(blocks, "set Cell forces = at 1.5: 0, -1"); });
    show_refusal([&] {
      loads_on(blocks, "set Cell forces = cell 0: 0, -1 at 2.9, 1.5");
    });
    show_refusal(
        [&] { loads_on(blocks, "set Cell forces = brick: 0, -1 at 2.9, 1"); });
  }

  check("nothing without a body force", loads_on(packing, "").body.empty());
  const Loads on_top = loads_on(packing, "set Traction = 1; 2\n"
                                         "set Where = ny > 0.5 && x < 0.5");
  right = true;
  for (unsigned int b = 0; b < on_top.traction.size(); ++b)
  {
    const auto &edge = packing.boundary_edges()[b];
    const bool loaded = edge.normal[1] > 0.5 && edge.midpoint()[0] < 0.5;
    right &= on_top.traction[b].norm() == (loaded ? std::sqrt(5.) : 0.);
  }
  check("a traction on a part of the boundary", right);

  // A load on a part of an edge, and a strength that jumps within an interface.
  const Packing<2> slab = wall(2, 1, 3., 2.);
  const auto partial =
      loads_on(slab, "set Traction = 0; x < 0.7 ? -20/0.7 : 0\n"
                     "set Where = ny > 0.5");
  double total = 0.;
  for (unsigned int b = 0; b < partial.traction.size(); ++b)
    total += slab.boundary_edges()[b].length * partial.traction[b][1];
  check_error("a load on a part of an edge", std::abs(total + 20.), 1e-11);
  const auto jump = strengths(slab, "x < 0.4 ? 5 : 1");
  for (unsigned int e = 0; e < jump.size(); ++e)
  {
    const auto &i = slab.interfaces()[e];
    if (std::min(i.start[0], i.end[0]) == 0.)
      check_error("a strength that jumps",
                  std::abs(jump[e] - (5. * 0.4 + i.length - 0.4) / i.length),
                  1e-12);
  }
  show_refusal([&] { strengths(slab, "1 + sin(1e7 * x)"); });

  // Where a traction is not asked for it need not be a number.
  check("a traction that is no number where it does not act",
        std::isfinite(loads_on(packing, "set Traction = 0; 1/x\n"
                                        "set Where = nx > 0.5")
                          .traction[0]
                          .norm()));
  // By its form there is no body force, and nothing to integrate.
  check("a body force of zero is none",
        loads_on(packing, "set Body force = 0.0; 0 * 2").body.empty());

  const Packing<2> bricks = wall(2, 1);
  show_refusal([&] { strengths(bricks, "-1"); });
  show_refusal([&] { strengths(bricks, "sqrt(0.25 - x)"); });
  show_refusal([&] { strengths(bricks, "1 +"); });
  show_refusal([&] { loads_on(bricks, "set Traction = 1/(y-1); 0"); });
  show_refusal([&] { loads_on(bricks, "set Traction = u; 0"); });
  show_refusal([&] {
    loads_on(bricks, "set Boundary load = uniform stress\n"
                     "set Stress = 1, 2; 3, 4");
  });
  show_refusal([&] { loads_on(bricks, "set Where = y > 2"); });
  show_refusal([&] { loads_on(bricks, "set Where = log(y - 5)"); });
  show_refusal([&] { loads_on(bricks, "set Body force = 0; 1/(x-x)"); });
  show_refusal([&] { loads_on(bricks, "set Cell forces = lintel: 0, 1"); });
  show_refusal([&] { loads_on(bricks, "set Cell forces = cell 9: 0, 1"); });
  show_refusal([&] { loads_on(bricks, "set Cell forces = brick: 1"); });
  show_refusal([&] { loads_on(bricks, "set Cell forces = brick"); });
  show_refusal([&] { loads_on(bricks, "set Cell forces = ground: 0, 1"); });
  check("a group with itself by one name",
        strengths(bricks, "1", "brick: 2") ==
            strengths(bricks, "1", "brick, brick: 2"));
  show_refusal([&] { strengths(bricks, "1", "brick, brick, brick: 2"); });
  show_refusal(
      [&] { strengths(bricks, "1", "brick, brick: 2; brick,brick: 3"); });
  show_refusal([&] { strengths(bricks, "1", "brick, ground: 2"); });
  show_refusal([&] { strengths(bricks, "1", "brick, stone: 2"); });
  show_refusal([&] { strengths(bricks, "1", "brick, brick: -2"); });
}

const RoomTest test("loads_and_strengths", run);
} // namespace test_loads_and_strengths
