// SPDX-License-Identifier: LGPL-2.1-or-later

// The shear wall stands if and only if s_T >= 1: above, bed joints carry the
// shear stress 1 and no normal stress; below, the courses slide, with a ratio
// of work to dissipation of at most 1 / s_T. Every formulation says so soon.

#include "tests.h"

namespace test_formulations_limit
{
using namespace Voussoir;

void try_strength(const Method &method, const double strength)
{
  const Scene scene = shear_wall(strength);
  const DiscreteProblem problem = discretise(scene);
  const Solution solution = Solver(method).solve(problem);
  std::cout << method.name << ", s_T = " << strength << ": ";
  if (solution.mechanism)
  {
    const auto proof = certify_mechanism(
        scene, dimensional_motion(discretise(scene), *solution.mechanism));
    std::cout << "collapse" << std::endl;
    check("  work above dissipation", proof.work_over_dissipation > 1.);
    check_error("  ratio of work to dissipation, over the largest",
                proof.work_over_dissipation * strength, 1. + 1e-9);
    check_error("  closing of joints", proof.closing_violation, 1e-14);
    check("  at most 30 evaluations", solution.n_evaluations <= 30);
    return;
  }

  std::cout << "carried" << std::endl;
  const InterfaceForces forces = dimensional_forces(problem, solution);
  const Certificate certificate = certify(scene, forces);
  check_error("  equilibrium", certificate.equilibrium_residual, 1e-6);
  check_error("  admissibility", certificate.admissibility_violation, 1e-6);
  double normal = 0., tangential = 0.;
  unsigned int unmarked = 0;
  for (unsigned int e = 0; e < forces.normal.size(); ++e)
  {
    const auto &i = scene.packing.interfaces()[e];
    if (std::abs(i.normal[1]) < 0.5)
      continue; // a head joint
    normal = std::max(normal, std::abs(forces.normal[e]) / i.length);
    tangential = std::max(
        tangential, std::abs(std::abs(forces.tangential[e]) / i.length - 1.));
    if (!solution.never_pressed.empty() && !solution.never_pressed[e])
      ++unmarked;
  }
  // No state is strictly admissible. Ipopt with hard contact approaches p = 0
  // as the square root of its barrier parameter; the linear program and the
  // centre have room in q, which is 1 in the mean over a course only.
  const double tolerance = method.name == "hard" ? 1e-3 : 1e-6;
  check_error("  normal stress of the bed joints", normal, tolerance);
  if (method.formulation == "smoothed friction" ||
      method.formulation == "least energy" || strength == 1.)
    check_error("  |q|/|e| - 1 of the bed joints", tangential, tolerance);
  if (method.formulation == "analytic centre")
  {
    check("  all bed joints marked as never pressed", unmarked == 0);
    check("  joints that always slide are at the limit only",
          (std::count(solution.always_sliding.begin(),
                      solution.always_sliding.end(), true) > 0) ==
              (strength == 1.));
  }
}

/** A wall of another shape has the same limit. */
void try_shape(const Method &method, const double width, const double height)
{
  for (const double strength : {1.5, 0.99})
  {
    const Scene scene = shear_wall(strength, width, height);
    const DiscreteProblem problem = discretise(scene);
    const Solution solution = Solver(method).solve(problem);
    std::cout << method.name << ", " << width << " x " << height
              << ", s_T = " << strength << ": "
              << (solution.mechanism ? "collapse" : "carried") << std::endl;
    if (!solution.mechanism)
      check_error("  equilibrium",
                  certify(scene, dimensional_forces(problem, solution))
                      .equilibrium_residual,
                  1e-6);
  }
}

/** Just above the limit marks are right or not given; the limit is obeyed. */
void try_marks(const Method &method)
{
  for (const double above : {1e-3, 1e-5, 1e-6, 1e-7, 1e-9})
  {
    const Scene scene = shear_wall(1. + above);
    const DiscreteProblem problem = discretise(scene);
    const Solution solution = Solver(method).solve(problem);
    bool right = solution.never_pressed.empty() ||
                 std::count(solution.always_sliding.begin(),
                            solution.always_sliding.end(), true) == 0;
    for (unsigned int e = 0; e < solution.never_pressed.size(); ++e)
      right &= solution.never_pressed[e] ==
               (std::abs(scene.packing.interfaces()[e].normal[1]) > 0.5);
    check(method.name + ": marks right or none", right);
    check(method.name + ": some at 1e-3",
          above < 1e-3 || !solution.never_pressed.empty());

    Solver solver(method);
    for (const unsigned int n : {1, 60, 75})
      check(method.name + ": within the iterations allowed",
            solver.parameters.formulation()
                    .solve(problem, {1e-10, n}, solver.quiet)
                    .n_iterations <= n);
  }
}

void run()
{
  for (const Method &method : all_methods)
    for (const double strength : {10., 1.5, 1.001, 1., 0.999, 0.9, 0.1})
      // Where every force is given, hard contact has no room at all.
      if (!(strength == 1. &&
            (method.name == "hard" || method.name == "linear program")))
        try_strength(method, strength);

  for (const Method &method : all_methods)
    for (const auto &[width, height] :
         {std::make_pair(2., 1.), {3., 1.}, {7., 1.}, {1., 100.}, {100., 1.}})
      try_shape(method, width, height);
  for (const Method &method : {centre, centre_equal})
    try_marks(method);
}

const RoomTest test("formulations_limit", run);
} // namespace test_formulations_limit
