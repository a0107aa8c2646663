// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters.h>
#include <voussoir/statics/find_collapse.h>
#include <voussoir/statics/least_energy.h>
#include <voussoir/statics/newton.h>
#include <voussoir/statics/settle.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace Voussoir
{
namespace
{
using Joint = Structure::Joint;

/**
 * After how many iterations the load may be one that is not carried; then the
 * barrier problem, whose iterates close no joint, finds the mechanism sooner.
 */
constexpr unsigned int n_before_doubt = 20;

/** With fewer cells a process has more to tell than to do. */
constexpr unsigned int least_cells_per_process = 500;

/** The shortest cut of Newton's own steps with which they are still good. */
constexpr double shortest_good_step = 0.01;
constexpr unsigned int n_own_steps = 15;
/** The first proximal term of weight, relative to stiffnesses of order one. */
constexpr double first_shift = 1e-3;
/** How near to the proximal minimum is near enough to move its centre. */
constexpr double inner_reduction = 0.1;
/** By how much the imbalance must fall for a smaller shift. */
constexpr double outer_reduction = 0.7;
/**
 * Steps to a proximal minimum that make it an easy and a hard one, and minima
 * after which to try a smaller shift even so.
 */
constexpr unsigned int n_easy = 5, n_hard = 20, n_patience = 4;

/**
 * The course of Newton's method: its own steps with hardly any proximal term,
 * which solve in one if no joint opens or slides. When many joints slide these
 * steps are cut short. Then the proximal point method: minimise with a term
 * around a centre, move the centre there, and make the term smaller as long as
 * that goes well.
 */
class ProximalSteps
{
public:
  explicit ProximalSteps(Newton &newton) : newton(newton), centre(newton.u())
  {
  }

  void advance()
  {
    const double length = newton.step(shift, centre);
    ++n_inner;
    if (shift == least_shift)
    {
      centre = newton.u();
      if (length < shortest_good_step || n_inner >= n_own_steps)
        restart(first_shift);
    }
    else if (newton.imbalance(shift, centre) <=
             inner_reduction * newton.imbalance())
      move_centre();
    else if (n_inner > n_hard)
      restart(10. * shift);
  }

private:
  void move_centre()
  {
    ++n_outer;
    const bool better =
        newton.imbalance() < outer_reduction * previous_imbalance;
    previous_imbalance = newton.imbalance();
    double smaller = shift;
    if (better || n_outer >= n_patience)
      smaller = n_inner <= n_easy ? shift / 100. : shift / 10.;
    if (smaller < shift)
      n_outer = 0;
    restart(std::max(smaller, 2. * least_shift));
  }

  void restart(const double new_shift)
  {
    shift = new_shift;
    centre = newton.u();
    n_inner = 0;
  }

  Newton &newton;
  std::vector<double> centre;
  double shift = least_shift;
  unsigned int n_inner = 0, n_outer = 0;
  double previous_imbalance = std::numeric_limits<double>::infinity();
};

/** What all processes are told about how to solve. */
struct Order
{
  LinearSolver linear_solver = LinearSolver::automatic;
  double tolerance = SolverControls().tolerance;
  unsigned int n_max_iterations = SolverControls().n_max_iterations;
};

Solution minimise_elastic(const SharedProblem &problem,
                          const Order &order,
                          const double displacement_unit,
                          Terminal &terminal)
{
  const Structure &structure = problem.structure();
  const ElasticJoint law(structure);
  JointSystem system(structure, order.linear_solver);
  Newton newton(structure, law, system,
                std::vector<double>(structure.n_dofs(), 0.));
  ProximalSteps proximal(newton);
  const auto advance = [&]() {
    std::optional<Mechanism> mechanism;
    if (newton.n_iterations() == n_before_doubt && problem.has_opening())
      mechanism = find_collapse(problem, terminal);
    if (!mechanism)
      proximal.advance();
    return mechanism;
  };
  NewtonControls until;
  until.imbalance = order.tolerance;
  until.n_max_iterations = order.n_max_iterations;
  return minimise(problem, newton, until, advance, displacement_unit, terminal);
}

/** The same by all processes; @p whole and @p order are the root's. */
Solution minimise_together(const DiscreteProblem *whole,
                           const Order &order,
                           const double displacement_unit,
                           const Team &team,
                           Terminal &terminal)
{
  return team.together([&]() {
    const Order of_root = team.broadcast(order);
    const dealii::Timer timer;
    const SharedProblem problem(whole, team);
    const double seconds_to_share = timer.wall_time();
    Solution solution =
        minimise_elastic(problem, of_root, displacement_unit, terminal);
    if (team.size() > 1)
      solution.seconds["sharing"] = seconds_to_share;
    return solution;
  });
}
} // namespace

ElasticJoint::ElasticJoint(const Structure &structure) : structure(structure)
{
}

JointLaw::Jump ElasticJoint::force(const unsigned int e, const Jump &jump) const
{
  const Joint &joint = structure.joints()[e];
  const double k = joint.stiffness();
  return {k * std::min(jump.normal, 0.),
          std::clamp(k * jump.tangential, -joint.strength, joint.strength)};
}

JointLaw::Jump ElasticJoint::second_derivative(const unsigned int e,
                                               const Jump &jump) const
{
  const Joint &joint = structure.joints()[e];
  const double k = joint.stiffness();
  const bool touches = jump.normal <= 0.;
  const bool sticks = k * std::abs(jump.tangential) < joint.strength;
  return {touches ? k : 0., sticks ? k : 0.};
}

std::string LeastEnergy::name() const
{
  return "least energy";
}

std::string LeastEnergy::meaning() const
{
  return "the least energy of elastic joints, solved by Newton's method; the "
         "fastest, from one cell to a million.";
}

std::string LeastEnergy::selection() const
{
  return "least energy: the least sum of d_e/|e| times the square of the force "
         "on the interface";
}

void LeastEnergy::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.add_parameter("Modulus", modulus,
                    "Of the elastic joints, whose stiffness is the modulus "
                    "times |e| / d_e. It divides the displacements in the "
                    "results and changes nothing else; a stress.",
                    Double(1e-100, 1e100));
  add_choice<LinearSolver>(
      prm, "Linear solver", linear_solver,
      {{LinearSolver::automatic, "automatic",
        "the faster one at the size of the packing."},
       {LinearSolver::direct, "direct", "CHOLMOD's Cholesky factorisation."},
       {LinearSolver::multigrid, "multigrid",
        "conjugate gradients with Trilinos' algebraic multigrid ML."}},
      "How the linear systems of Newton's method are solved.");
}

Solution LeastEnergy::select(const DiscreteProblem &problem,
                             const SolverControls &controls,
                             Terminal &terminal) const
{
  const Order order = {linear_solver, controls.tolerance,
                       controls.n_max_iterations};
  const double displacement_unit =
      problem.stress_scale() * problem.length_scale() / modulus;
  const bool is_shared =
      problem.n_cells() >= least_cells_per_process * controls.team.size();
  const Team team = is_shared ? controls.team : Team();
  team.call(Team::Task::least_energy);
  const Solution solution =
      minimise_together(&problem, order, displacement_unit, team, terminal);
  std::vector<JointCost> costs;
  for (const Joint &joint : problem.joints())
    costs.push_back({1. / joint.stiffness(), 1. / joint.stiffness(), 0.});
  return settle(problem, costs, controls, displacement_unit, solution,
                terminal);
}

void assist_least_energy(const Team &team, Terminal &terminal)
{
  try
  {
    minimise_together(nullptr, {}, 0., team, terminal);
  }
  catch (const SolverError &)
  {
    // All processes have it; the root reports it.
  }
}

std::optional<Mechanism> find_collapse_by_springs(const SharedProblem &problem,
                                                  Terminal &terminal)
{
  return minimise_elastic(problem, {}, 0., terminal).mechanism;
}
} // namespace Voussoir
