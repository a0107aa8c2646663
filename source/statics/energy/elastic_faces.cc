// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/newton.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/energy/elastic_faces.h>
#include <voussoir/statics/energy/face_joint.h>
#include <voussoir/statics/energy/proximal_steps.h>

#include <utility>

namespace Voussoir
{
namespace
{
/** The imbalance from which on a few more steps bring all digits. */
constexpr double near_minimum = 1e-4;
/** The steps behind the tolerance, and the imbalance that is rounding. */
constexpr unsigned int n_steps_to_rounding = 3;
constexpr double rounding_of_steps = 1e-14;

/** Near its end each step doubles the digits; the imbalance that is left. */
double go_to_rounding(Newton &newton,
                      const double tolerance,
                      std::vector<double> &forces,
                      std::vector<double> &u)
{
  forces = newton.forces();
  u = newton.u();
  double least = newton.imbalance();
  for (unsigned int n = 0; n < n_steps_to_rounding &&
                           least > rounding_of_steps && least <= tolerance;
       ++n)
  {
    try
    {
      newton.full_step();
    }
    catch (const NewtonFailure &)
    {
      break;
    }
    if (!(newton.imbalance() < least))
      break;
    least = newton.imbalance();
    forces = newton.forces();
    u = newton.u();
  }
  return least;
}

/** The part of each process. */
FaceMinimum minimise_part(const SharedProblem &problem,
                          const FaceOrder &order,
                          std::vector<double> start,
                          Terminal &terminal)
{
  const FaceJoint law(
      problem.structure(),
      problem.of_joints([](const DiscreteProblem &whole, const unsigned int e) {
        return whole.tension(e);
      }));
  JointSystem system(problem.structure(), order.linear_solver);
  Newton newton(problem.structure(), law, system, std::move(start));
  ProximalSteps proximal(newton);
  try
  {
    while (newton.imbalance() > order.tolerance &&
           (newton.n_iterations() < order.n_steps ||
            (newton.imbalance() < near_minimum &&
             newton.n_iterations() < 2 * order.n_steps)))
    {
      proximal.advance();
      terminal.iteration("Newton", text("iteration ", newton.n_iterations(),
                                        ", imbalance ", newton.imbalance()));
    }
  }
  catch (const NewtonFailure &)
  {
    // Where it was before.
  }
  FaceMinimum found;
  std::vector<double> forces, u;
  found.imbalance = go_to_rounding(newton, order.tolerance, forces, u);
  found.solution.n_iterations = newton.n_iterations();
  found.solution.n_evaluations = newton.n_evaluations();
  found.solution.seconds["linear systems"] = newton.seconds_of_systems();
  problem.collect(u, forces, found.solution);
  return found;
}

/** By all processes; @p whole, @p order and @p start are the root's. */
FaceMinimum minimise_by_all(const DiscreteProblem *whole,
                            const FaceOrder &order,
                            const std::vector<double> &start,
                            const ProcessGroup &processes,
                            Terminal &terminal)
{
  return processes.together([&]() {
    const FaceOrder of_root = processes.broadcast(order);
    const SharedProblem problem(whole, processes);
    return minimise_part(
        problem, of_root,
        problem.displacement([&](const DiscreteProblem &) { return start; }),
        terminal);
  });
}
} // namespace

FaceMinimum minimise_faces(const DiscreteProblem &whole,
                           const FaceOrder &order,
                           const std::vector<double> &start,
                           const ProcessGroup &processes,
                           Terminal &terminal)
{
  const ProcessGroup helpers = SharedProblem::helpers(whole, processes);
  helpers.call(faces_task);
  return minimise_by_all(&whole, order, start, helpers, terminal);
}

void work_on_faces(const ProcessGroup &processes, Terminal &terminal)
{
  minimise_by_all(nullptr, {}, {}, processes, terminal);
}
} // namespace Voussoir
