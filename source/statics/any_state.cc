// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/any_state.h>

#include <cmath>
#include <utility>

namespace Voussoir
{
namespace
{
std::vector<bool> held_bodies(const DiscreteProblem &problem)
{
  std::vector<bool> held(problem.n_bodies());
  for (unsigned int b = 0; b < held.size(); ++b)
    held[b] = problem.is_held(b);
  return held;
}

/** The mechanism of a ray, along which the loads do work for nothing. */
std::vector<double> collapse_of(RayProblem &problem,
                                const SelfDual::Loads &loads,
                                SelfDual::Point ray)
{
  const double size = largest_component(ray.u);
  for (auto *const v : {&ray.u, &ray.z})
    for (double &component : *v)
      component /= size;
  return mechanism_near(problem.forces, loads, ray);
}
} // namespace

RayProblem::RayProblem(const DiscreteProblem &problem)
    : problem(problem), rays(problem), forces(rays, held_bodies(problem))
{}

Motion RayProblem::motion_of(std::vector<double> u) const
{
  const double size = largest_component(u);
  for (double &component : u)
    component /= size;
  problem.hold_bodies(u);
  return problem.motion_of_cells(u, problem.length_scale());
}

AnyForces find_any_forces(RayProblem &problem,
                          const std::vector<double> &loads,
                          const unsigned int n_max_iterations,
                          Terminal &terminal)
{
  const SelfDual::Loads fixed = {loads, {}, 1.};
  SelfDual program(problem.forces, fixed);
  SelfDual::State state = SelfDual::State::running;
  AnyForces found;
  while (state == SelfDual::State::running && !found.state &&
         program.n_iterations() < n_max_iterations)
  {
    state = program.step();
    terminal.iteration("Interior point",
                       text("iteration ", program.n_iterations(), ", error ",
                            program.merit()));
    if (!(program.merit() < merit_worth_correcting))
      continue;
    FactorState near = state_near(problem.forces, fixed, program.point());
    if (near.residual <= largest_residual_of_state)
      found.state = std::move(near);
  }
  if (state == SelfDual::State::infeasible)
    found.collapse = collapse_of(problem, fixed, program.point());
  found.n_iterations = program.n_iterations();
  return found;
}

Solution AnyState::select(const DiscreteProblem &problem,
                          const SolverControls &controls,
                          Terminal &terminal) const
{
  RayProblem by_rays(problem);
  std::vector<double> loads = problem.loads();
  by_rays.forces.clear_held(loads);
  const AnyForces found =
      find_any_forces(by_rays, loads, controls.n_max_iterations, terminal);
  Solution solution;
  solution.n_iterations = solution.n_evaluations = found.n_iterations;
  if (found.state)
  {
    solution.stop = Stop::Reason::converged;
    solution.forces = by_rays.rays.forces_of(found.state->x);
    solution.motion = Motion(problem.n_cells(), problem.kinematics());
    return solution;
  }
  if (found.collapse.empty())
    throw SolverError(
        text("Neither forces that carry the loads nor a mechanism were found "
             "after ",
             counted(found.n_iterations, "iteration"),
             ". The load is close to what the packing can carry, or "
             "'Solver/Maximum iterations' is small."));
  solution.stop = Stop::Reason::collapse;
  double dissipation = 0.;
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    dissipation +=
        problem.limit(e) * std::abs(problem.sliding(e, found.collapse.data()));
  solution.mechanism =
      Mechanism{by_rays.motion_of(found.collapse),
                problem.work(found.collapse.data()), dissipation};
  return solution;
}
} // namespace Voussoir
