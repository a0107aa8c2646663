// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/statics/energy/elastic_problem.h>
#include <voussoir/statics/energy/energy_program.h>
#include <voussoir/statics/energy/minimise.h>
#include <voussoir/statics/energy/proximal_steps.h>
#include <voussoir/statics/problem/equilibrate.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace Voussoir
{
namespace
{

/** The error of the EnergyProgram, which goes the rest of the way where
 * Newton's method is_in_doubt(), from which that takes one to seven steps. */
constexpr double error_to_start_from = 1e-8;
/** The imbalance that the rounding of small displacements leaves. */
constexpr double rounding_of_balance = 1e-12;

/** The part of the joints that slide after the first step that is much. */
constexpr double many_slide = 0.25;
/** The factor for the secant share after a good step, and its end. */
constexpr double smaller_secant_share = 0.35, least_secant_share = 0.01;
/** The length of a bad step, the factor for the share then, and a new share. */
constexpr double bad_step = 0.3, larger_secant_share = 5.,
                 new_secant_share = 0.1;

/**
 * The secant share of the steps. Where many joints slide Newton's first steps,
 * in which these have no stiffness at all, are far too long and go astray:
 * steps begin with a share, and end without. Measured, random cells under
 * pressures of 1.2 and 0.8, strengths from 0.18 to 0.12: 215 steps in all, at
 * most 14, instead of 324, at most 23.
 */
class SecantShare
{
public:
  SecantShare(const Structure &structure, ElasticJoint &law)
      : structure(structure), law(law)
  {}

  /** Steps are Newton's from now on. */
  void end()
  {
    share = 0.;
    law.set_secant_share(share);
  }

  /** To be called after each step, of which @p length is the length. */
  void adapt(const Newton &newton, const double length)
  {
    if (newton.n_iterations() == 1)
      serves = share_that_slides(newton) > many_slide;
    if (length < bad_step)
      share = share > 0. ? std::min(1., larger_secant_share * share)
                         : new_secant_share;
    else
      share *= smaller_secant_share;
    // The end is Newton's.
    if (!serves || share < least_secant_share ||
        newton.imbalance() <= imbalance_without_doubt)
      share = 0.;
    law.set_secant_share(share);
  }

private:
  double share_that_slides(const Newton &newton) const
  {
    const unsigned int n = structure.joints().size();
    unsigned int n_sliding = 0;
    for (unsigned int e = 0; e < n; ++e)
      n_sliding += law.slides(e, &newton.jumps()[structure.first_row(e)]);
    const ProcessGroup &processes = structure.processes();
    return double(processes.sum(n_sliding)) / std::max(processes.sum(n), 1U);
  }

  const Structure &structure;
  ElasticJoint &law;
  bool serves = false;
  double share = 1.;
};

/**
 * Balance the forces of a @p solution next to the limit: displacements are so
 * large there that jumps, and the forces in them, have few digits.
 */
void balance_to_rounding(const DiscreteProblem &problem, Solution &solution)
{
  if (solution.converged() &&
      largest_component(imbalance(problem, solution.forces)) >
          rounding_of_balance)
    solution.forces = equilibrate(problem, solution.forces);
}
} // namespace

ElasticJoint::ElasticJoint(const Structure &structure) : structure(structure) {}

void ElasticJoint::find_forces(const unsigned int e,
                               const double *jumps,
                               double *forces) const
{
  const Structure::Joint &joint = structure.joints()[e];
  const unsigned int n = structure.n_contacts(e);
  for (unsigned int r = 0; r < n; ++r)
    forces[r] = structure.contact_stiffness(e) * std::min(jumps[r], 0.);
  forces[n] =
      std::clamp(joint.stiffness() * jumps[n], -joint.strength, joint.strength);
}

bool ElasticJoint::find_second_derivatives(const unsigned int e,
                                           const double *jumps,
                                           double *second) const
{
  const unsigned int n = structure.n_contacts(e);
  for (unsigned int r = 0; r < n; ++r)
    second[r] = jumps[r] <= 0. ? structure.contact_stiffness(e) : 0.;
  const double jump = std::abs(jumps[n]);
  if (!slides(e, jumps))
    second[n] = structure.joints()[e].stiffness();
  else // it has no secant where it slides without a force
    second[n] = jump > 0. ? secant_share * structure.limit(e) / jump : 0.;
  return is_isotropic(second, n);
}

bool ElasticJoint::slides(const unsigned int e, const double *jumps) const
{
  const double jump = std::abs(jumps[structure.n_contacts(e)]);
  return !(structure.joints()[e].stiffness() * jump < structure.limit(e));
}

Solution minimise_elastic(const SharedProblem &problem,
                          const ElasticOrder &order,
                          std::vector<double> start,
                          Terminal &terminal)
{
  const Structure &structure = problem.structure();
  ElasticJoint law(structure);
  JointSystem system(structure, order.linear_solver);
  start.resize(structure.n_dofs(), 0.);
  Newton newton(structure, law, system, std::move(start));
  std::optional<ProximalSteps> proximal(newton);
  SecantShare secant(structure, law);
  // On the root.
  EnergyProgram program;
  const DiscreteProblem *of_program = nullptr;
  const double first_imbalance = newton.imbalance();
  bool has_doubts = false;
  const auto advance = [&]() {
    std::optional<Mechanism> mechanism;
    if (!has_doubts && is_in_doubt(newton, first_imbalance))
    {
      has_doubts = true;
      std::vector<double> u =
          problem.displacement([&](const DiscreteProblem &whole) {
            // Of what friction hardly takes part in, it says more.
            const double error =
                error_to_start_from * std::min(1., whole.largest_limit());
            program = solve_energy_program(
                whole, elastic_costs(whole), error,
                order.n_max_iterations - newton.n_iterations(), terminal);
            of_program = &whole;
            program.u.resize(whole.n_dofs(), 0.);
            return program.u;
          });
      mechanism = problem.search(u, [&](const DiscreteProblem & /*whole*/,
                                        const std::vector<double> & /*u*/) {
        return program.mechanism;
      });
      if (mechanism)
        return mechanism;
      newton.restart(std::move(u));
      proximal.emplace(newton);
      secant.end();
    }
    secant.adapt(newton, proximal->advance());
    return mechanism;
  };
  Solution solution =
      minimise(problem, newton, {order.tolerance, order.n_max_iterations},
               advance, terminal);
  solution.n_iterations += program.n_iterations;
  if (of_program)
    balance_to_rounding(*of_program, solution);
  return solution;
}
} // namespace Voussoir
