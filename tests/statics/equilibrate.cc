// SPDX-License-Identifier: LGPL-2.1-or-later

// Forces that do not balance are corrected as little as possible: known
// corrections come out, every formulation's loose answers balance to rounding
// afterwards, and no answer gets worse.

#include <voussoir/scene/proofs/certificate.h>
#include <voussoir/statics/problem/equilibrate.h>

#include "tests.h"
#include <cmath>

namespace test_equilibrate
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** The larger error of the certificate. */
double error(const Scene &scene, const InterfaceForces &forces)
{
  const Certificate certificate = certify(scene, forces);
  return std::max(certificate.equilibrium_residual,
                  certificate.admissibility_violation);
}

/**
 * Answers of all formulations with a loose tolerance, which hard contact and
 * the centres do not use to the full.
 */
void tighten(const std::string &name, const Scene &scene)
{
  for (const Method &method : all_methods)
  {
    const double before = error(scene, Solver(method, 1e-2).forces(scene));
    const double after = error(
        scene, Solver(method, 1e-2, "set Equilibrate = true").forces(scene));
    check_error(name + ", " + method.name + ": balanced and admissible", after,
                1e-13);
    check("  no worse than before", after <= std::max(before, 1e-15));
  }
}

/** n unit squares on top of each other under a pressure of 1. */
Scene pile(const unsigned int n)
{
  CellLoops cells;
  cells.vertices = {{0., 0.}, {1., 0.}};
  for (unsigned int k = 0; k < n; ++k)
  {
    cells.vertices.emplace_back(0., k + 1.);
    cells.vertices.emplace_back(1., k + 1.);
    for (const unsigned int v : {2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2})
      cells.loops.push_back(v);
    cells.first.push_back(cells.loops.size());
  }
  return scene_under_stress(Packing<2>(cells), 1., tensor(0., 0., 0., -1.));
}

/** A pile is determinate: whatever the forces were, there is one answer. */
void try_pile()
{
  const Scene scene = pile(5);
  const DiscreteProblem problem = discretise(scene);
  Solution solution;
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    solution.forces.push_back(-1e-3 * (e + 1.));
    solution.forces.push_back(0.1 * e);
  }
  solution.forces = equilibrate(problem, solution.forces);
  const InterfaceForces forces = dimensional_forces(problem, solution);
  for (unsigned int e = 0; e < forces.normal.size(); ++e)
  {
    check_error("a pile, normal force", std::abs(forces.normal[e] + 1.), 1e-13);
    check_error("  tangential force", std::abs(forces.tangential[e]), 1e-13);
  }
}

/** Normal and tangential force of each joint. */
using Forces = std::vector<double>;

/** sum_e (d_e/|e|) a_e . b_e */
double product(const DiscreteProblem &problem, const Forces &a, const Forces &b)
{
  double sum = 0.;
  for (unsigned int k = 0; k < a.size(); ++k)
    sum += a[k] * b[k] / problem.joints()[k / 2].stiffness();
  return sum;
}

Forces difference(const Forces &a, const Forces &b)
{
  Forces d = a;
  for (unsigned int k = 0; k < a.size(); ++k)
    d[k] -= b[k];
  return d;
}

/**
 * Far from all limits the correction is the smallest one: normal, in its norm,
 * to the difference of any two balanced states.
 */
void try_smallest()
{
  const Scene scene = scene_under_stress(random_packing(100, 1), 10.,
                                         tensor(-1.2, 0.1, 0.1, -0.8));
  const DiscreteProblem problem = discretise(scene);
  const Forces even = Solver(least_energy).solve(problem).forces;
  const Forces other =
      difference(Solver(centre_equal).solve(problem).forces, even);
  Forces wrong = even;
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    wrong[2 * e] *= 1. + 0.05 * std::sin(e);
    wrong[2 * e + 1] += 0.05 * problem.joints()[e].length * std::cos(e);
  }
  const Forces change = difference(equilibrate(problem, wrong), wrong);
  check("there is something to correct",
        product(problem, change, change) > 1e-4 * product(problem, even, even));
  check_error("the correction is the smallest",
              std::abs(product(problem, change, other)) /
                  std::sqrt(product(problem, change, change) *
                            product(problem, other, other)),
              1e-10);
}

/** What cannot be balanced is not made worse. */
void try_impossible()
{
  const Scene scene = shear_wall(0.9);
  const DiscreteProblem problem = discretise(scene);
  Solution solution = Solver(least_energy).solve(problem);
  check("a wall that slides has no forces", solution.mechanism.has_value());
  const unsigned int n = problem.joints().size();
  for (const double pressure : {0., 0.5, 1.})
  {
    for (unsigned int e = 0; e < n; ++e)
    {
      solution.forces[2 * e] = -pressure;
      solution.forces[2 * e + 1] = pressure;
    }
    const double before = error(scene, dimensional_forces(problem, solution));
    solution.forces = equilibrate(problem, solution.forces);
    const double after = error(scene, dimensional_forces(problem, solution));
    check("  and no correction finds them", after > 1e-3);
    check("  nor makes them worse", after <= (1. + 1e-12) * before);
  }
}

/** Forces at their limits stay there. */
void try_limits()
{
  const Scene scene = scene_under_stress(random_packing(200, 2), 0.3,
                                         tensor(-1.4, 0., 0., -0.6));
  const DiscreteProblem problem = discretise(scene);
  Forces forces = Solver(least_energy).solve(problem).forces;
  unsigned int n_limits = 0, n_kept = 0;
  std::vector<bool> slides;
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const double strength = problem.joints()[e].strength;
    slides.push_back(std::abs(forces[2 * e + 1]) >= strength);
    n_limits += slides[e];
    if (!slides[e])
      forces[2 * e] *= 1. + 1e-3 * std::sin(e);
  }
  const Forces balanced = equilibrate(problem, forces);
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    n_kept += slides[e] && balanced[2 * e + 1] == forces[2 * e + 1];
  check("joints slide", n_limits > 10);
  check("  and slide on", n_kept == n_limits);
}

void run()
{
  try_pile();
  try_smallest();
  tighten("grains", scene_under_stress(random_packing(200, 2), 0.5,
                                       tensor(-1.3, 0.1, 0.1, -0.7)));
  tighten("a wall in shear", shear_wall(1.5));
  try_impossible();

  try_limits();

  const Scene scene = shear_wall(1.2);
  const DiscreteProblem problem = discretise(scene);
  const Solution loose = Solver(compliant, 1e-2).solve(problem);
  const Solution balanced =
      Solver(compliant, 1e-2, "set Equilibrate = true").solve(problem);
  check("nothing is corrected that nobody asked for", !loose.correction);
  double largest = 0.;
  double change = 0.;
  for (unsigned int k = 0; k < loose.forces.size(); ++k)
  {
    largest = std::max(
        {largest, std::abs(loose.forces[k]), std::abs(balanced.forces[k])});
    change = std::max(change, std::abs(loose.forces[k] - balanced.forces[k]));
  }
  check("the correction is told",
        std::abs(balanced.correction.value() - change / largest) < 1e-15 &&
            balanced.correction > 1e-6);
}

const RoomTest test("equilibrate", run);
} // namespace test_equilibrate
