// SPDX-License-Identifier: LGPL-2.1-or-later

// Packings that stand on the ground: the stress in a column grows with depth,
// the reaction is the weight, clamped blocks hang by friction, and what has no
// interior of the contact constraints is named.

#include <voussoir/packing/generators/arch.h>
#include <voussoir/scene/proofs/reactions.h>
#include <voussoir/scene/supports.h>
#include <voussoir/statics/problem/find_opening.h>

#include "tests.h"

namespace test_supports
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** A scene under its weight, supported where @p condition holds. */
Scene under_weight(Packing<2> packing,
                   const double strength,
                   const double gamma,
                   const std::string &condition)
{
  packing.support(boundary_edges_where(packing, condition, "Supports/Where"));
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  loads.body = BodyForce(packing, [=](const Point<2> &, unsigned int) {
    return Tensor<1, 2>({0., -gamma});
  });
  const std::vector<double> strengths(packing.interfaces().size(), strength);
  return Scene(std::move(packing), strengths, std::move(loads));
}

/** Blocks on top of each other: a stack bond one block wide. */
Packing<2> column(const std::vector<double> &heights, const double width)
{
  CellLoops cells;
  cells.vertices = {{0., 0.}, {width, 0.}};
  for (unsigned int k = 0; k < heights.size(); ++k)
  {
    const double y = cells.vertices.back()[1] + heights[k];
    cells.vertices.emplace_back(0., y);
    cells.vertices.emplace_back(width, y);
    for (const unsigned int v : {2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2})
      cells.loops.push_back(v);
    cells.first.push_back(cells.loops.size());
  }
  return Packing<2>(cells);
}

/** A flat arch of n wedges between vertical jambs, joints leaning outwards. */
Packing<2> flat_arch(const unsigned int n, const double lean)
{
  CellLoops cells;
  for (unsigned int k = 0; k <= n; ++k)
  {
    const double x = 2. * k / n - 1.;
    const double shift = k == 0 || k == n ? 0. : lean * x;
    cells.vertices.emplace_back(x, 0.);
    cells.vertices.emplace_back(x + shift, 1.);
  }
  for (unsigned int k = 0; k < n; ++k)
  {
    for (const unsigned int v : {2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1})
      cells.loops.push_back(v);
    cells.first.push_back(cells.loops.size());
  }
  return Packing<2>(cells);
}

double total_weight(const Scene &scene)
{
  double sum = 0.;
  for (const Tensor<1, 2> &F : scene.load)
    sum += F.norm();
  return sum;
}

void check_certificate(const std::string &what,
                       const Scene &scene,
                       const InterfaceForces &forces)
{
  const Certificate certificate = certify(scene, forces);
  check_error(what + ": residual", certificate.equilibrium_residual, 1e-9);
  check_error(what + ": violation", certificate.admissibility_violation, 1e-9);
}

void run()
{
  // The stress at depth z of a column is -gamma z, whatever the formulation.
  const double gamma = 20.;
  const std::vector<double> heights = {0.3, 1., 0.01, 2., 0.5, 0.7, 0.2};
  const Scene pile = under_weight(column(heights, 0.4), 1., gamma, "y < 1e-9");
  double top = 0.;
  for (const double h : heights)
    top += h;
  for (const Method &method : all_methods)
  {
    const InterfaceForces forces = Solver(method, 1e-13).forces(pile);
    double error = 0.;
    for (unsigned int e = 0; e < forces.normal.size(); ++e)
    {
      const auto &i = pile.packing.interfaces()[e];
      const double expected = -gamma * (top - i.midpoint()[1]);
      error = std::max(error,
                       std::abs(forces.normal[e] / i.length / expected - 1.));
    }
    check_error("column, " + method.name + ": stress over gamma z - 1", error,
                1e-12);
  }

  // The reaction is the weight.
  const Scene brickwork =
      under_weight(wall(30, 12, 3., 2.), 5., gamma, "y < 0.01");
  for (const Method &method : all_methods)
  {
    const InterfaceForces forces = Solver(method).forces(brickwork);
    const auto ground = reactions(brickwork, forces);
    check("wall, " + method.name + ": one straight support of the right length",
          ground.size() == 1 && ground[0].start == Point<2>(0., 0.) &&
              ground[0].end == Point<2>(3., 0.));
    check_error("wall, " + method.name + ": reaction over weight - 1",
                std::abs(ground[0].force[1] / (6. * gamma) - 1.), 1e-12);
    check_error("wall, " + method.name + ": imbalance on the ground",
                balance_on_ground(brickwork, ground).imbalance, 1e-12);
    check_certificate("wall, " + method.name, brickwork, forces);
  }

  // A block between two walls hangs by friction on both of its sides if they
  // bear half of its weight each; the contact problem has no interior.
  for (const double strength : {0.51, 0.49})
  {
    const Scene clamped =
        under_weight(column({1.}, 1.), strength, 1., "abs(nx) > 0.5");
    const DiscreteProblem problem = discretise(clamped);
    check("clamped: nothing opens both sides",
          opening_of(problem).displacement.empty());
    for (const Method &method : {least_energy, compliant})
    {
      const Solution solution = Solver(method).solve(problem);
      if (strength > 0.5)
      {
        const InterfaceForces forces = dimensional_forces(problem, solution);
        check_certificate("clamped, " + method.name, clamped, forces);
        check_error("clamped, " + method.name +
                        ": half of the weight on each side",
                    std::max(std::abs(std::abs(forces.tangential[0]) - 0.5),
                             std::abs(std::abs(forces.tangential[1]) - 0.5)),
                    1e-9);
      }
      else
        check("clamped, " + method.name + ": falls by a mechanism",
              solution.mechanism &&
                  certify_mechanism(clamped,
                                    dimensional_motion(discretise(clamped),
                                                       *solution.mechanism))
                          .work_over_dissipation > 1.);
    }
    if (strength > 0.5)
      for (const Method &method : {hard, linear_program, centre})
        show_refusal([&] { Solver(method).solve(problem); });
  }

  // So does a wall between two others; its courses cannot rise one by one.
  for (const double strength : {0., 0.3, 0.49, 0.51})
  {
    const Scene clamped =
        under_weight(wall(20, 10), strength, 1., "abs(nx) > 0.5");
    const DiscreteProblem problem = discretise(clamped);
    for (const Method &method : {least_energy, compliant})
    {
      const Solution solution = Solver(method).solve(problem);
      if (strength > 0.5)
        check_certificate("clamped wall, " + method.name, clamped,
                          dimensional_forces(problem, solution));
      else
        check("clamped wall, " + method.name + ": falls by a mechanism",
              solution.mechanism &&
                  certify_mechanism(clamped,
                                    dimensional_motion(discretise(clamped),
                                                       *solution.mechanism))
                          .work_over_dissipation > 1.);
    }
  }

  // And an arch on piers that are held at their sides, too.
  ArchGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.set("Mean radius", 3.);
  prm.set("Embrace", 100.);
  prm.set("Thickness", 0.4);
  prm.set("Voussoirs", 17L);
  prm.set("Abutments", 5L);
  prm.set("Abutment height", 2.);
  for (const double strength : {16., 20., 21.4, 21.5})
  {
    const Scene piers =
        under_weight(Packing<2>(generator.generate("", Terminal::silent())),
                     strength, 22., "y < 0.001");
    const DiscreteProblem problem = discretise(piers);
    check("arch on held piers: clamped",
          opening_of(problem).displacement.empty());
    const Solution solution = Solver(least_energy).solve(problem);
    if (strength > 21.48)
      check_certificate("arch on held piers", piers,
                        dimensional_forces(problem, solution));
    else
      check(
          "arch on held piers: falls",
          solution.mechanism &&
              certify_mechanism(piers, dimensional_motion(discretise(piers),
                                                          *solution.mechanism))
                      .work_over_dissipation > 1.);
  }

  // Supports that face each other may leave an interior all the same: the
  // wedges of a flat arch can rise.
  const Scene arch = under_weight(flat_arch(7, 0.2), 1.2, 1., "abs(nx) > 0.99");
  check("flat arch: two supports", arch.packing.n_supports() == 2);
  const DiscreteProblem arch_problem = discretise(arch);
  const std::vector<double> opening = opening_of(arch_problem).displacement;
  bool opens = !opening.empty();
  for (unsigned int e = 0; e < arch_problem.joints().size(); ++e)
    opens &= arch_problem.opening(e, opening.data()) > 0.;
  check("flat arch: a motion opens every joint", opens);
  for (const Method &method : all_methods)
    check_certificate("flat arch, " + method.name, arch,
                      Solver(method).forces(arch));

  // Grains in a box: supported below and at both sides, open above.
  const Scene box = under_weight(random_packing(300, 4), 0.2, 1., "ny < 0.5");
  check_certificate("box, least energy", box, Solver(least_energy).forces(box));

  // A corner: supports that do not face each other always leave an interior.
  const Scene corner =
      under_weight(random_packing(50, 2), 0.1, 1., "ny < -0.5 || nx < -0.5");
  for (const Method &method : all_methods)
    check_certificate("corner, " + method.name, corner,
                      Solver(method).forces(corner));

  // What floats is named.
  CellLoops apart;
  for (unsigned int k = 0; k < 8; ++k)
  {
    const double x = 2. * k;
    for (const Point<2> &p : {Point<2>(x, 0.), Point<2>(x + 1., 0.),
                              Point<2>(x + 1., 1.), Point<2>(x, 1.)})
    {
      apart.loops.push_back(apart.vertices.size());
      apart.vertices.push_back(p);
    }
    apart.first.push_back(apart.loops.size());
  }
  show_refusal([&] { under_weight(Packing<2>(apart), 1., 1., "x < 1"); });
  show_refusal([&] { under_weight(Packing<2>(apart), 1., 1., "x < 13"); });
  show_refusal([&] { under_weight(Packing<2>(apart), 1., 1., "x < -1"); });

  // So are the gap beside it, and a contact in a point.
  CellLoops two;
  two.vertices = {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}};
  for (const Point<2> &p :
       {Point<2>(0., 1.1), Point<2>(1., 1.1), Point<2>(0.5, 2.)})
    two.vertices.push_back(p);
  two.add({0, 1, 2, 3});
  two.add({4, 5, 6});
  show_refusal([&] { under_weight(Packing<2>(two), 1., 1., "y < 0.1"); });
  two.vertices[4] = {1., 1.};
  two.vertices[5] = {2., 1.};
  show_refusal([&] { under_weight(Packing<2>(two), 1., 1., "y < 0.1"); });
}

const RoomTest test("supports", run);
} // namespace test_supports
