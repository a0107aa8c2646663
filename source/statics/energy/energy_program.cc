// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/conic/factor_bounds.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/conic/proven_factor.h>
#include <voussoir/statics/energy/energy_program.h>

#include <algorithm>
#include <limits>
#include <new>
#include <utility>

namespace Voussoir
{
namespace
{
/**
 * The most iterations; it takes 10 to 30 (measured), with hardly any friction
 * up to 100.
 */
constexpr unsigned int n_max_of_energy = 200;

/**
 * Where the loads may be beyond the limit: kappa over tau, over its least value
 * so far, and the growth of the displacement over the forces, at which a proof
 * of collapse is tried.
 */
constexpr double growth_of_doubt = 3., growth_of_motion = 4.;
/** The iterations before any proof is tried. */
constexpr unsigned int n_before_proofs = 3;
/** The largest closing of a motion that is a proof. */
constexpr double largest_closing_of_collapse = 1e-12;

/** The error of the program at which its forces are those of the minimum. */
constexpr double error_of_minimum = 1e-14, accepted_error_of_minimum = 1e-11;

/** The program of one problem. */
class EnergySearch
{
public:
  EnergySearch(const DiscreteProblem &problem,
               const std::vector<JointCost> &costs,
               Terminal &terminal)
      : problem(problem), terminal(terminal),
        rows(problem,
             has_smoothing(costs) ? ForceRows::Friction::in_arcs
                                  : ForceRows::Friction::bounded),
        program{rows.loads(), {}, 1., linear_costs(costs), true},
        forces(rows, held_bodies(), curvatures(costs))
  {
    forces.clear_held(program.dead);
  }

  EnergyProgram find(double error, unsigned int n_max_iterations);

private:
  static bool has_smoothing(const std::vector<JointCost> &costs)
  {
    return std::any_of(costs.begin(), costs.end(), [](const JointCost &cost) {
      return cost.smoothing > 0.;
    });
  }
  std::vector<bool> held_bodies() const
  {
    std::vector<bool> held;
    for (unsigned int b = 0; b < problem.n_bodies(); ++b)
      held.push_back(problem.is_held(b));
    return held;
  }
  std::vector<double> curvatures(const std::vector<JointCost> &costs) const;
  std::vector<double> linear_costs(const std::vector<JointCost> &costs) const;
  std::optional<Mechanism> collapse_near(const SelfDual::Point &point);

  const DiscreteProblem &problem;
  Terminal &terminal;
  const ForceRows rows;
  SelfDual::Program program;
  ConicForces forces;
};

std::vector<double>
EnergySearch::curvatures(const std::vector<JointCost> &costs) const
{
  std::vector<double> q(rows.n_all_rows(), 0.);
  for (unsigned int e = 0; e < costs.size(); ++e)
  {
    double *const of_joint = &q[rows.first_row(e)];
    if (problem.is_plane())
      of_joint[problem.n_contacts(e)] = costs[e].tangential_compliance;
    else
      problem.for_each_face_set(e, [&](const Structure::FaceSet &set) {
        std::fill_n(of_joint + set.row, set.size,
                    costs[e].tangential_compliance / set.share);
      });
    problem.for_each_pressure(
        e, [&](const unsigned int row, const double share) {
          of_joint[row] = costs[e].normal_compliance / share;
        });
  }
  return q;
}

/** Of what arcs leave, and of the tension that is the origin of forces. */
std::vector<double>
EnergySearch::linear_costs(const std::vector<JointCost> &costs) const
{
  std::vector<double> c(rows.n_all_rows(), 0.);
  for (unsigned int e = 0; e < costs.size(); ++e)
  {
    // The share in the force is that in the stiffness.
    problem.for_each_pressure(e, [&](const unsigned int row, double) {
      c[rows.first_row(e) + row] =
          costs[e].normal_compliance * problem.tension(e);
    });
  }
  for (const ForceRows::Arc &arc : rows.arcs())
    c[arc.row + 1] = -costs[rows.joint_of_row(arc.row)].smoothing;
  return c;
}

/** A mechanism near a point, whose motion grows as there is no minimum. */
std::optional<Mechanism>
EnergySearch::collapse_near(const SelfDual::Point &point)
{
  SelfDual::Program collapse;
  collapse.dead.assign(program.dead.size(), 0.);
  collapse.live = program.dead;
  const double work = dot(collapse.live, point.u);
  if (!(work > 0.))
    return {};
  SelfDual::Point of_work_one = point;
  for (auto *const v : {&of_work_one.u, &of_work_one.z})
    for (double &component : *v)
      component /= work;
  const FactorMotion motion = mechanism_near(forces, collapse, of_work_one);
  if (motion.closing > largest_closing_of_collapse)
    return {};
  return problem.is_plane() ? find_mechanism(problem, motion.u)
                            : mechanism_by_rows(rows, motion.u);
}

EnergyProgram EnergySearch::find(const double error,
                                 const unsigned int n_max_iterations)
{
  const unsigned int n_max = std::min(n_max_of_energy, n_max_iterations);
  // What is not a number is no better.
  const InvalidOperationsAllowed allowed;
  SelfDual search(forces, program);
  SelfDual::State state = SelfDual::State::running;
  EnergyProgram best;
  best.error = std::numeric_limits<double>::infinity();
  std::optional<SelfDual::Point> nearest;
  double least_doubt = std::numeric_limits<double>::infinity(),
         last_growth = std::numeric_limits<double>::infinity();
  while (state == SelfDual::State::running && !(best.error <= error) &&
         search.n_iterations() < n_max && !best.mechanism)
  {
    state = search.step();
    terminal.iteration(
        "Interior point",
        text("iteration ", search.n_iterations(), ", error ", search.merit()));
    if (search.merit() < best.error)
    {
      best.error = search.merit();
      nearest = search.point();
    }
    if (search.n_iterations() < n_before_proofs || !(search.gain() > 0.))
      continue;
    const SelfDual::Point point = search.point();
    const double growth =
        largest_component(point.u) / largest_component(point.x);
    last_growth = std::min(last_growth, growth);
    least_doubt = std::min(least_doubt, search.doubt());
    if (search.doubt() > growth_of_doubt * least_doubt ||
        growth > growth_of_motion * last_growth ||
        state == SelfDual::State::infeasible)
    {
      last_growth = growth;
      best.mechanism = collapse_near(point);
    }
  }
  best.n_iterations = search.n_iterations();
  if (best.mechanism || !nearest)
    return best;
  best.u = std::move(nearest->u);
  if (!problem.is_plane())
  {
    // Within all limits and balanced, near enough to the minimum.
    const FactorState state = state_near(forces, {program.dead}, *nearest);
    best.forces = rows.forces_of(
        state.residual <= largest_residual_of_state ? state.x : nearest->x);
    return best;
  }
  best.forces.reserve(problem.n_all_rows());
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const unsigned int n = problem.n_contacts(e);
    for (unsigned int r = 0; r <= n; ++r)
      best.forces.push_back(nearest->x[rows.first_row(e) + r] +
                            (r < n ? problem.tension(e) / n : 0.));
  }
  return best;
}
} // namespace

std::vector<JointCost> elastic_costs(const DiscreteProblem &problem)
{
  std::vector<JointCost> costs;
  costs.reserve(problem.joints().size());
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const Joint &joint = problem.joints()[e];
    const double compliance = 1. / joint.stiffness();
    costs.push_back(
        {compliance,
         problem.is_plane() ? compliance : compliance / joint.tangential_part(),
         0.});
  }
  return costs;
}

EnergyProgram solve_energy_program(const DiscreteProblem &problem,
                                   const std::vector<JointCost> &costs,
                                   const double error,
                                   const unsigned int n_max_iterations,
                                   Terminal &terminal)
{
  return EnergySearch(problem, costs, terminal).find(error, n_max_iterations);
}

Solution second_attempt(const DiscreteProblem &problem,
                        const std::vector<JointCost> &costs,
                        const SolverControls &controls,
                        Solution solution,
                        Terminal &terminal)
{
  if (solution.converged() || solution.mechanism ||
      solution.n_iterations >= controls.n_max_iterations)
    return solution;
  try
  {
    EnergyProgram found = solve_energy_program(
        problem, costs, error_of_minimum,
        controls.n_max_iterations - solution.n_iterations, terminal);
    solution.n_iterations += found.n_iterations;
    solution.n_evaluations += found.n_iterations;
    if (found.mechanism)
    {
      solution.stop = Stop::Reason::collapse;
      solution.mechanism = std::move(found.mechanism);
    }
    else if (found.error <= accepted_error_of_minimum)
    {
      solution.stop = Stop::Reason::converged;
      solution.forces = std::move(found.forces);
      solution.u = std::move(found.u);
      problem.remove_rigid_motions(solution.u);
    }
  }
  catch (const SolverError &)
  {
    // The first answer stands.
  }
  catch (const std::bad_alloc &)
  {
    // The first answer stands.
  }
  return solution;
}
} // namespace Voussoir
