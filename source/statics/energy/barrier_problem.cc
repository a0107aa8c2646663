// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/statics/energy/barrier_problem.h>
#include <voussoir/statics/energy/minimise.h>
#include <voussoir/statics/problem/solver_controls.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/**
 * With this decrement the forces of the next step are right to its square. It
 * is the same for every tolerance, so that the centre is, too.
 */
constexpr double largest_decrement = 1e-7;
/**
 * The same for the forces themselves. In joints that are much stronger than
 * their load the decrement says little on them, and rounding leaves in each
 * step a part of their error.
 */
constexpr double largest_barrier_change = 1e-6;

/**
 * Newton's method takes up to 25 iterations where there is a centre or a
 * mechanism (measured: 60 to 10,000 cells, at 0.1 to 2 of the limit load).
 */
constexpr unsigned int n_max_newton_iterations = 50;

/** The work of a load, over the size of its terms, that is not rounding. */
constexpr double least_resistance = 1e-10;
} // namespace

std::vector<double> start_of_barrier(const SharedProblem &problem,
                                     const BarrierJoint &law)
{
  const Structure &structure = problem.structure();
  std::vector<double> u = problem.opening();

  double sum_of_weights = 0.;
  for (unsigned int e = 0; e < structure.joints().size(); ++e)
    if (structure.is_own(structure.joints()[e]))
      sum_of_weights += structure.n_contacts(e) * law.contact_weight(e);
  double size_of_terms = 0.;
  for (unsigned int k = 0; k < structure.n_own_dofs(); ++k)
    size_of_terms += std::abs(structure.loads()[k] * u[k]);
  const double resistance = -structure.work(u.data());
  if (resistance > least_resistance * structure.processes().sum(size_of_terms))
  {
    const double factor =
        structure.processes().sum(sum_of_weights) / resistance;
    for (double &component : u)
      component *= factor;
  }
  return u;
}

Solution minimise_barrier(const SharedProblem &problem,
                          const BarrierJoint &law,
                          JointSystem &system,
                          const double tolerance,
                          const unsigned int n_max_iterations,
                          Terminal &terminal)
{
  Newton newton(problem.structure(), law, system,
                start_of_barrier(problem, law));
  const auto advance = [&]() -> std::optional<Mechanism> {
    newton.step(least_shift, newton.u());
    return {};
  };
  const NewtonControls until = {
      tolerance, std::min(n_max_newton_iterations, n_max_iterations),
      largest_decrement, largest_barrier_change};
  // No displacement of its own: the barrier's grows with its parameter.
  return minimise(problem, newton, until, advance, terminal);
}
} // namespace Voussoir
