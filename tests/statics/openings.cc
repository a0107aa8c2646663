// SPDX-License-Identifier: LGPL-2.1-or-later

// Whether a motion opens every joint, and the proof of it, computed again here:
// a motion that opens all of them, or normal forces that balance by themselves.
// Wedges of any taper can rise, in any direction and with any origin that
// leaves the coordinates digits for it; what is held on all sides is clamped.

#include <voussoir/scene/supports.h>
#include <voussoir/statics/problem/find_opening.h>

#include "tests.h"

namespace test_openings
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** A block that is wider above by twice the taper, turned and moved. */
Packing<2> wedge(const double taper, const double angle, const Point<2> &origin)
{
  CellLoops cells;
  for (const Point<2> &x : {Point<2>(0., 0.), Point<2>(1., 0.),
                            Point<2>(1. + taper, 1.), Point<2>(-taper, 1.)})
    cells.vertices.emplace_back(
        origin[0] + std::cos(angle) * x[0] - std::sin(angle) * x[1],
        origin[1] + std::sin(angle) * x[0] + std::cos(angle) * x[1]);
  cells.loops = {0, 1, 2, 3};
  cells.first.push_back(4);
  return Packing<2>(cells);
}

/** The scene with some of its edges as supports, without friction. */
template <typename IsSupport>
Scene held(Packing<2> packing,
           const Tensor<1, 2> &weight,
           const IsSupport &is_support)
{
  std::vector<bool> supports;
  for (const Packing<2>::BoundaryEdge &edge : packing.boundary_edges())
    supports.push_back(is_support(edge));
  packing.support(supports);
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  loads.body = BodyForce(
      packing, [=](const Point<2> &, unsigned int) { return weight; });
  const std::vector<double> strengths(packing.interfaces().size(), 0.);
  return Scene(std::move(packing), strengths, std::move(loads));
}

/** The sides of the wedge: those that @p up does not face. */
Scene held_wedge(const double taper,
                 const double angle = 0.,
                 const Point<2> &origin = Point<2>())
{
  Tensor<1, 2> down;
  down[0] = std::sin(angle);
  down[1] = -std::cos(angle);
  return held(wedge(taper, angle, origin), down, [&](const auto &edge) {
    return std::abs(edge.normal * down) < 0.5;
  });
}

/** Whether the motion opens every joint. */
bool opens(const DiscreteProblem &problem)
{
  const std::vector<double> &u = opening_of(problem).displacement;
  bool all_open = u.size() == problem.n_dofs();
  for (unsigned int e = 0; all_open && e < problem.joints().size(); ++e)
    all_open = problem.opening(e, u.data()) > 0.;
  return all_open;
}

/** What the normal forces leave on the cells, over their sum. */
double imbalance_of_self_stress(const Scene &scene,
                                const DiscreteProblem &problem)
{
  const std::vector<double> &rows = opening_of(problem).self_stress;
  if (rows.size() != 2 * scene.packing.interfaces().size())
    return 1e300;
  std::vector<Tensor<1, 2>> sum(scene.packing.n_cells() + 1);
  double size = 0.;
  for (unsigned int e = 0; e < rows.size() / 2; ++e)
  {
    const Packing<2>::Interface &i = scene.packing.interfaces()[e];
    const double p = rows[2 * e];
    if (!(p >= 0.))
      return 1e300;
    sum[i.cell_minus] += p * i.normal;
    sum[i.cell_plus] -= p * i.normal;
    size += p;
  }
  double left = 0.;
  for (unsigned int c = 0; c < scene.packing.n_cells(); ++c)
    left += sum[c].norm();
  return size > 0. ? left / size : 1e300;
}

void run()
{
  // p = W / (2 sin(atan(taper))) on both sides.
  for (const double taper : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10})
    for (const double angle : {0., 0.3})
    {
      const Scene scene = held_wedge(taper, angle);
      const DiscreteProblem problem = discretise(scene);
      std::ostringstream name;
      name << "taper " << taper << ", turned by " << angle;
      check(name.str() + ": opens", opens(problem));
      check(name.str() + ": no self-stress",
            opening_of(problem).self_stress.empty());
      const InterfaceForces forces = Solver(centre).forces(scene);
      const double expected =
          scene.packing.area() / (2. * std::sin(std::atan(taper)));
      check_error(name.str() + ": normal forces over expected - 1, times taper",
                  taper * std::max(std::abs(-forces.normal[0] / expected - 1.),
                                   std::abs(-forces.normal[1] / expected - 1.)),
                  1e-15);
      check_error(name.str() + ": residual",
                  certify(scene, forces).equilibrium_residual,
                  std::max(1e-10, 1e-16 / taper));
    }

  // A taper that the coordinates have no digits for is neither.
  const Scene far = held_wedge(1e-10, 0.3, Point<2>(1e6, 1e6));
  const DiscreteProblem far_problem = discretise(far);
  check("taper 1e-10 at 1e6: not taken for an opening",
        opening_of(far_problem).displacement.empty());

  // Clamped: parallel walls, however turned and wherever they are.
  for (const double angle : {0., 0.1, 0.3, 1., 2.})
    for (const double origin : {0., 100., 1e6})
    {
      const Scene scene = held_wedge(0., angle, Point<2>(origin, -origin));
      const DiscreteProblem problem = discretise(scene);
      std::ostringstream name;
      name << "parallel, turned by " << angle << " at " << origin;
      check(name.str() + ": no opening",
            opening_of(problem).displacement.empty());
      check_error(name.str() + ": self-stress",
                  imbalance_of_self_stress(scene, problem),
                  1e-14 * (1. + origin));
    }

  // Held on all sides nothing opens: the flux through a closed frame is zero.
  Tensor<1, 2> down;
  down[1] = -1.;
  const auto all_sides = [](const auto &) { return true; };
  for (const unsigned int seed : {1u, 2u, 3u})
  {
    const Scene scene = held(random_packing(200, seed), down, all_sides);
    const DiscreteProblem problem = discretise(scene);
    check("frame: no opening", opening_of(problem).displacement.empty());
    check_error("frame: self-stress", imbalance_of_self_stress(scene, problem),
                1e-12);
  }
  // Bricks between two walls: each course is clamped.
  const Scene bricks = held(wall(20, 10), down, [](const auto &edge) {
    return std::abs(edge.normal[0]) > 0.5;
  });
  const DiscreteProblem brick_problem = discretise(bricks);
  check("bricks: no opening", opening_of(brick_problem).displacement.empty());
  check_error("bricks: self-stress",
              imbalance_of_self_stress(bricks, brick_problem), 1e-12);

  // Grains in an open box: whichever it is, it is proven.
  for (const unsigned int seed : {1u, 2u, 3u, 4u})
  {
    const Scene scene =
        held(random_packing(300, seed), down,
             [](const auto &edge) { return edge.normal[1] < 0.5; });
    const DiscreteProblem problem = discretise(scene);
    check("box: one proof", opens(problem) != (imbalance_of_self_stress(
                                                   scene, problem) <= 1e-12));
  }
}

const RoomTest test("openings", run);
} // namespace test_openings
