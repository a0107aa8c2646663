// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/newton.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/energy/proximal_steps.h>
#include <voussoir/statics/paper/smoothed_faces.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Voussoir
{
namespace
{
/** The steps of Newton's method to the point that Ipopt starts from. */
constexpr unsigned int n_steps_to_start = 12;
/**
 * The balance of all cells decides when to stop; Ipopt, which does not see that
 * of the cells held in place, must not stop before.
 */
constexpr double ipopt_over_tolerance = 1e-3;

/** What Ipopt minimises, and the point with the best balance on its way. */
class SmoothedFacesProgram : public JointEnergyProgram
{
public:
  SmoothedFacesProgram(const DiscreteProblem &problem,
                       const SmoothedFace &law,
                       const SolverControls &controls)
      : JointEnergyProgram(problem, law), problem(problem), law(law),
        controls(controls)
  {
    find_start();
  }

  std::vector<double> start() const override { return of_start; }
  std::vector<double> gradient(const double *x) override
  {
    std::vector<double> g = JointEnergyProgram::gradient(x);
    best.see(x, g);
    return g;
  }
  Stop verdict(const unsigned int iteration) override
  {
    return best.verdict(iteration, controls.tolerance);
  }

  /** Ipopt's answer, with the point of the best balance. */
  Solution solve(Terminal &terminal)
  {
    IpoptControls ipopt = {ipopt_over_tolerance * controls.tolerance,
                           controls.n_max_iterations};
    Solution solution =
        std::move(solve_program(problem, *this, ipopt, terminal).solution);
    solution.n_iterations += n_steps;
    solution.n_evaluations += n_steps;
    if (solution.mechanism || best.point().empty())
      return solution;
    solution.u = best.point();
    solution.forces = forces_at(solution.u);
    problem.remove_rigid_motions(solution.u);
    if (best.imbalance() <= controls.tolerance)
      solution.stop = Stop::Reason::converged;
    return solution;
  }

private:
  void find_start();

  const DiscreteProblem &problem;
  const SmoothedFace &law;
  const SolverControls &controls;
  std::vector<double> of_start;
  BestBalance best;
  unsigned int n_steps = 0;
};

/** A few steps of Newton's method from rest. */
void SmoothedFacesProgram::find_start()
{
  of_start.assign(problem.n_dofs(), 0.);
  JointSystem system(problem, LinearSolver::automatic);
  Newton newton(problem, law, system, of_start);
  ProximalSteps proximal(newton);
  double least = newton.imbalance();
  try
  {
    while (newton.n_iterations() < n_steps_to_start &&
           newton.imbalance() > ipopt_over_tolerance * controls.tolerance)
    {
      proximal.advance();
      if (!(newton.imbalance() < least))
        continue;
      least = newton.imbalance();
      of_start = newton.u();
    }
  }
  catch (const NewtonFailure &)
  {
    // From where it was before.
  }
  n_steps = newton.n_iterations();
}
} // namespace

double SmoothedFace::energy(const unsigned int e, const double *jumps) const
{
  const double eps = smoothing(e), stiffness = problem.joints()[e].stiffness();
  double energy = 0.;
  problem.for_each_face_set(e, [&](const Structure::FaceSet &set) {
    const double *const jump = jumps + set.row;
    if (set.size == 1)
    {
      if (*jump < 0.)
        energy += 0.5 * stiffness * set.share * *jump * *jump;
      return;
    }
    // sqrt(x^2 + eps^2) - eps without its cancellation.
    const double x = std::hypot(jump[0], jump[1]);
    energy += set.strength * x * (x / (std::hypot(x, eps) + eps));
  });
  return energy;
}

void SmoothedFace::find_forces(const unsigned int e,
                               const double *jumps,
                               double *forces) const
{
  const double eps = smoothing(e), stiffness = problem.joints()[e].stiffness();
  problem.for_each_face_set(e, [&](const Structure::FaceSet &set) {
    const double *const jump = jumps + set.row;
    double *const force = forces + set.row;
    if (set.size == 1)
    {
      *force = stiffness * set.share * std::min(*jump, 0.);
      return;
    }
    const double root = std::hypot(jump[0], jump[1], eps);
    for (unsigned int i = 0; i < 2; ++i)
      force[i] = set.strength * (jump[i] / root);
  });
}

bool SmoothedFace::find_second_derivatives(const unsigned int e,
                                           const double *jumps,
                                           double *second) const
{
  const double eps = smoothing(e), stiffness = problem.joints()[e].stiffness();
  problem.for_each_face_set(e, [&](const Structure::FaceSet &set) {
    const double *const jump = jumps + set.row;
    double *const block = second + set.coefficient;
    if (set.size == 1)
    {
      *block = *jump <= 0. ? stiffness * set.share : 0.;
      return;
    }
    const double root = std::hypot(jump[0], jump[1], eps);
    const double t[] = {jump[0] / root, jump[1] / root};
    const double of_eps = eps / root;
    // 1 - t_i^2 without its cancellation.
    block[0] = set.strength / root * (of_eps * of_eps + t[1] * t[1]);
    block[3] = set.strength / root * (of_eps * of_eps + t[0] * t[0]);
    block[1] = block[2] = -set.strength / root * t[0] * t[1];
  });
  return false;
}

Solution SmoothedFaces::select(const DiscreteProblem &problem,
                               const SolverControls &controls,
                               Terminal &terminal) const
{
  const SmoothedFace law(problem);
  Solution solution =
      SmoothedFacesProgram(problem, law, controls).solve(terminal);
  if (solution.converged() || solution.mechanism)
    return solution;
  Solution any = FeasibleState().solve(problem, controls, terminal);
  any.n_iterations += solution.n_iterations;
  any.n_evaluations += solution.n_evaluations;
  if (any.converged())
    any.selection = FeasibleState().selection();
  return any;
}
} // namespace Voussoir
