// SPDX-License-Identifier: LGPL-2.1-or-later

// Loads that are next to nothing beside the strengths: verdicts on both sides
// of limits at which forces have no scale, with the proofs of the user's files.

#include <voussoir/base/text.h>
#include <voussoir/scene/proofs/certificate.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/problem/mechanism.h>

#include "coulomb_scenes.h"
#include "tests.h"
#include <cmath>
#include <limits>

namespace test_strong_limits
{
using namespace Voussoir;
using dealii::Tensor;

/** The strengths over the loads. */
constexpr double sizes[] = {1e2, 1e8, 1e10};

enum class Verdict
{
  carried,
  collapses
};

/** The verdict, and its proof. */
void compare(const std::string &name, const Scene &scene, const Verdict verdict)
{
  const DiscreteProblem problem = discretise(scene);
  const Solution found = find_state_or_collapse(
      problem, SolverControls().n_max_iterations, Terminal::silent());
  if (verdict == Verdict::carried)
  {
    check(name + " is carried", found.converged());
    if (found.converged())
      check_error("  forces",
                  certify(scene, dimensional_forces(problem, found)).error(),
                  1e-12);
    return;
  }
  check(name + " collapses", found.mechanism.has_value());
  if (found.mechanism)
    check("  mechanism",
          proves_collapse(certify_mechanism(
              scene, dimensional_motion(problem, *found.mechanism))));
}

/** With all strengths @p size times the weight of a metre. */
Scene with_strengths(Scene scene, const double size, const bool crushes)
{
  scene.strength.assign(scene.strength.size(), 10. * size);
  if (crushes)
    scene.compressive_strength.assign(scene.strength.size(), 10. * size);
  return scene;
}

/** What is taken out of any motion is what the user's files say. */
void dissipation()
{
  for (const bool turn : {false, true})
    for (const double mu : {0., 0.6})
    {
      Scene scene = wall_under(3, 3, 3., -10., mu, 0.);
      scene.kinematics = turn ? &rotations() : &translations();
      const std::size_t n = scene.packing.interfaces().size();
      for (std::size_t e = 0; e < n; ++e)
      {
        scene.strength[e] = 2. + e % 3;
        scene.tensile_strength.push_back(e % 2 == 0 ? 0. : 0.7);
        scene.compressive_strength.push_back(5. + e % 5);
      }
      const DiscreteProblem problem = discretise(scene);
      double error = 0.;
      for (unsigned int k = 0; k < 20; ++k)
      {
        Mechanism motion;
        for (unsigned int i = 0; i < problem.n_dofs(); ++i)
          motion.u.push_back(std::sin(1. + i + 100. * k * k));
        problem.remove_rigid_motions(motion.u);
        if (problem.work(motion.u.data()) < 0.)
          for (double &component : motion.u)
            component = -component;
        const double ratio = problem.work(motion.u.data()) /
                             dissipation_of(problem, motion.u.data());
        const double from_files =
            certify_mechanism(scene, dimensional_motion(problem, motion))
                .work_over_dissipation;
        error = std::max(error, std::abs(ratio / from_files - 1.));
      }
      check_error(text("dissipation, mu ", mu, turn ? ", turning" : ""), error,
                  1e-10);
    }
}

/** Stacks turn about an edge of their foot as if they were one block. */
void stacks()
{
  const double exact = 10. * 0.4 / (8 * 0.175);
  for (const double size : sizes)
    for (const bool crushes : {false, true})
    {
      const std::string name = text(size, crushes ? ", crushing" : "");
      compare("a stack, " + name,
              with_strengths(wall_under(8, 1, 0.95 * exact, -10., 0.6, 0.),
                             size, crushes),
              Verdict::carried);
      compare("  pushed further",
              with_strengths(wall_under(8, 1, 1.001 * exact, -10., 0.6, 0.),
                             size, crushes),
              Verdict::collapses);
    }
}

/** The same with a strong joint beside each dry one. */
void mixed_stacks()
{
  const double exact = 10. * 0.4 / (8 * 0.175);
  for (const double size : sizes)
    for (const auto &[push, verdict] :
         {std::make_pair(0.95, Verdict::carried),
          std::make_pair(1.001, Verdict::collapses)})
    {
      Scene scene = wall_under(8, 1, push * exact, -10., 0.6, 0.);
      for (std::size_t e = 0; e < scene.strength.size(); ++e)
      {
        scene.strength[e] = e % 2 == 0 ? 0. : 10. * size;
        scene.compressive_strength.push_back(
            e % 3 == 0 ? std::numeric_limits<double>::infinity() : 1e4 * size);
      }
      compare(text("mixed, ", size, ", push ", push), scene, verdict);
    }
}

/** Forces between supports all around may be of any size. */
void clamped()
{
  for (const unsigned int seed : {1u, 2u})
  {
    Packing<2> cells = random_packing(60, seed, {{0., 0.}, {1., 3.}});
    cells.support(std::vector<bool>(cells.boundary_edges().size(), true));
    compare(text("clamped cells, seed ", seed),
            under(cells, Tensor<1, 2>({-350., -160.}), 0.34, 0.),
            Verdict::carried);
  }
}

/** Dry walls whose blocks do not turn slide on their foot, or not. */
void walls()
{
  for (const double size : sizes)
    for (const double push : {4., 5.01, 20.})
    {
      Scene scene = wall_under(6, 4, push, -10., 0.5, 0.);
      scene.kinematics = &translations();
      scene.compressive_strength.assign(scene.strength.size(), 10. * size);
      compare(text("a wall, ", size, ", push ", push), scene,
              push < 5. ? Verdict::carried : Verdict::collapses);
    }
}

/** What is pulled apart comes apart, however it sticks to itself along joints.
 */
void random_cells()
{
  for (const double size : sizes)
    for (const unsigned int seed : {1u, 2u})
    {
      const Packing<2> cells = random_packing(40, seed);
      Loads loads;
      for (const Packing<2>::BoundaryEdge &edge : cells.boundary_edges())
        loads.traction.push_back(edge.normal);
      std::vector<double> cohesion(cells.interfaces().size(), size);
      Scene scene(cells, cohesion, loads, rotations());
      scene.coefficient.assign(cohesion.size(), 0.7);
      compare(text("random cells, ", size, ", seed ", seed), scene,
              Verdict::collapses);
    }
}

void run()
{
  dissipation();
  stacks();
  mixed_stacks();
  clamped();
  walls();
  random_cells();
}

const RoomTest test("strong_limits", run);
} // namespace test_strong_limits
