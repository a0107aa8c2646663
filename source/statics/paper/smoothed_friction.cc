// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/newton.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/statics/energy/energy_program.h>
#include <voussoir/statics/paper/compliant_start.h>
#include <voussoir/statics/paper/hard_contact.h>
#include <voussoir/statics/paper/joint_energy_program.h>
#include <voussoir/statics/paper/smoothed_friction.h>
#include <voussoir/statics/paper/smoothed_joint.h>
#include <voussoir/statics/problem/find_opening.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace Voussoir
{

namespace
{
/**
 * With compliant contact the balance of all cells decides when to stop. Ipopt
 * does not see that of the cells held in place, where the imbalance of all
 * others adds up, and must not stop before.
 */
constexpr double ipopt_over_own_tolerance = 1e-3;

/**
 * With hard contact Ipopt's tolerance bounds the error of the product of normal
 * force and opening, too, and must be well below that product, or the forces
 * are those of some other point of the central path.
 */
constexpr double tolerance_over_barrier = 1e-2;

/**
 * The iterations with compliant contact after which an interior-point method
 * may have the answer sooner: elsewhere Ipopt takes some dozens (measured),
 * close to the limit of the load some hundreds, or none are enough.
 */
constexpr unsigned int n_before_interior_point = 60;

/**
 * The steps of Newton's method that follow on the interior point, and the
 * imbalance that needs none: the interior point's small products leave forces
 * off by up to 1e-7 (measured), and a step leaves the square of that.
 */
constexpr unsigned int n_sharpenings = 3;
constexpr double imbalance_to_refine = 1e-12;

/**
 * The part of the opening, whose largest component is one, from which Ipopt
 * starts once more with hard contact where it ends without an answer: with
 * hardly any friction it may lose its way (measured, one scene of 10,000).
 */
constexpr double nearer_start = 0.01;

/** The energy of SmoothedJoint; the unknowns are the displacements alone. */
class SmoothedFrictionProgram : public JointEnergyProgram
{
public:
  SmoothedFrictionProgram(const DiscreteProblem &problem,
                          const Contact contact,
                          const SolverControls &controls,
                          const double barrier_parameter,
                          Terminal &terminal)
      : JointEnergyProgram(problem, law), problem(problem), contact(contact),
        law(problem, contact), controls(controls),
        barrier_parameter(barrier_parameter), terminal(terminal)
  {
    // Hard contact starts where every joint is open.
    if (contact == Contact::hard)
      of_start.displacement = opening_of(problem).displacement;
    else
      of_start = compliant_start(problem, law, controls, terminal);
  }

  std::vector<double> start() const override { return of_start.displacement; }

  std::vector<double> gradient(const double *x) override
  {
    std::vector<double> g = JointEnergyProgram::gradient(x);
    if (contact == Contact::compliant)
      best.see(x, g);
    return g;
  }
  unsigned int n_constraints() const override
  {
    return contact == Contact::hard ? problem.n_all_contacts() : 0;
  }
  std::vector<Entry> constraints() const override
  {
    std::vector<Entry> entries;
    if (contact == Contact::hard)
      add_opening_entries(problem, entries);
    return entries;
  }
  Stop verdict(const unsigned int iteration) override
  {
    if (contact == Contact::hard)
      return {};
    const Stop stop = best.verdict(iteration, controls.tolerance);
    if (stop == Stop::Reason::converged)
      return stop;
    if (iteration >= n_before_interior_point && !interior)
    {
      Solution before;
      before.n_iterations = iteration;
      ask_interior_point(std::move(before));
      if (has_answer())
        return interior->stop;
    }
    return stop;
  }

  /** Solve with @p ipopt: the forces, and the displacement with eps = 1. */
  Solution solve(const IpoptControls &ipopt)
  {
    Solution solution;
    if (of_start.mechanism)
    {
      solution.stop = Stop::Reason::collapse;
      solution.mechanism = of_start.mechanism;
    }
    else
      solution = best_of(solve_program(problem, *this, ipopt, terminal));
    if (contact == Contact::hard && !solution.converged() &&
        !solution.mechanism && solution.stop != Stop::Reason::most_iterations)
      start_nearer(ipopt, solution);
    solution.displacement_unit = 1. / law.unit_smoothing();
    solution.n_iterations += of_start.n_iterations;
    solution.n_evaluations += of_start.n_evaluations;
    return solution;
  }

private:
  /** Solve again from nearer to contact, and take that if it is an answer. */
  void start_nearer(const IpoptControls &ipopt, Solution &solution)
  {
    for (double &component : of_start.displacement)
      component *= nearer_start;
    try
    {
      Solution second = best_of(solve_program(problem, *this, ipopt, terminal));
      second.n_iterations += solution.n_iterations;
      second.n_evaluations += solution.n_evaluations;
      if (second.converged() || second.mechanism)
        solution = std::move(second);
    }
    catch (const SolverError &)
    {
      // The first answer stands.
    }
  }

  /** Of Ipopt and the interior-point method. */
  Solution best_of(ProgramResult result)
  {
    if (has_answer())
    {
      interior->n_evaluations += result.solution.n_evaluations;
      return *interior;
    }
    Solution solution = solution_of_ipopt(std::move(result));
    if (interior)
      return solution;
    ask_interior_point(std::move(solution));
    return *interior;
  }

  /** second_attempt(), by the same state; with hard contact for a collapse. */
  void ask_interior_point(Solution before)
  {
    const bool was_converged = before.converged();
    if (contact == Contact::hard)
    {
      interior = std::move(before);
      if (!was_converged && !interior->mechanism &&
          (interior->mechanism = find_collapse(problem, terminal)))
        interior->stop = Stop::Reason::collapse;
      return;
    }
    interior = second_attempt(problem, smoothed_costs(problem, law), controls,
                              std::move(before), terminal);
    if (interior->converged() && !was_converged)
      refine_compliant_contact(*interior);
  }

  /** True if the interior-point method has an answer. */
  bool has_answer() const
  {
    return interior && (interior->converged() || interior->mechanism);
  }

  Solution solution_of_ipopt(ProgramResult result) const
  {
    std::vector<double> x = best.point().empty() ? result.x : best.point();
    const std::vector<double> &multipliers = result.multipliers;
    Solution solution = std::move(result.solution);
    if (solution.mechanism)
      return solution;
    solution.forces = forces_at(x);
    // Ipopt's multiplier of y_e >= 0 is -p_e.
    if (contact == Contact::hard)
      set_normal_forces(problem, multipliers, solution.forces);
    if (contact == Contact::hard)
      refine_hard_contact(problem, law, barrier_parameter, x,
                          controls.tolerance, solution);
    problem.remove_rigid_motions(x);
    solution.u = std::move(x);
    return solution;
  }

  /** Take Newton's own steps from the interior point's displacement. */
  void refine_compliant_contact(Solution &solution) const
  {
    JointSystem system(problem, LinearSolver::automatic);
    Newton newton(problem, law, system, solution.u);
    double least = newton.imbalance();
    try
    {
      for (unsigned int k = 0; k < n_sharpenings && least > imbalance_to_refine;
           ++k)
      {
        newton.full_step();
        if (!(newton.imbalance() < least))
          break;
        least = newton.imbalance();
        if (least > controls.tolerance)
          continue;
        solution.forces = newton.forces();
        solution.u = newton.u();
      }
    }
    catch (const SolverError &)
    {
      // What was found stands.
    }
  }

  const DiscreteProblem &problem;
  const Contact contact;
  const SmoothedJoint law;
  const SolverControls &controls;
  const double barrier_parameter;
  Terminal &terminal;
  /** Where Ipopt starts. */
  CompliantStart of_start;
  /** The result of the interior-point method, if it was run. */
  std::optional<Solution> interior;
  /** Of the points of compliant contact. */
  BestBalance best;
};
} // namespace

std::string SmoothedFriction::selection() const
{
  return contact == Contact::compliant
             ? "smoothed friction with compliant contact: least energy of the "
               "contact springs, with the most even use of friction"
             : "smoothed friction with hard contact: the most even use of "
               "friction, then the analytic centre of the normal forces";
}

void SmoothedFriction::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  add_choice<Contact>(
      prm, "Contact", contact,
      {{Contact::compliant, "compliant",
        "springs in compression; forces in proportion to the geometry, fast."},
       {Contact::hard, "hard",
        "no interpenetration, as in the paper; short edges may carry very "
        "large stresses."}},
      "How contact selects the normal forces. Both give admissible and "
      "balanced forces of the rigid blocks.");
  prm.add_parameter("Smoothing length", smoothing_length,
                    "The length eps in sqrt(x^2 + eps^2) - eps. It is the unit "
                    "of the displacements in the results and changes nothing "
                    "else; a length.",
                    Double(1e-100, 1e100));
  prm.add_parameter("Barrier parameter", barrier_parameter,
                    "The product of normal force and opening, nondimensional "
                    "and the same in every joint, at which hard contact stops: "
                    "small enough not to move the forces, and large enough for "
                    "the solver to meet it.",
                    Double(1e-12, 1e-2));
}

Solution SmoothedFriction::select(const DiscreteProblem &problem,
                                  const SolverControls &controls,
                                  Terminal &terminal) const
{
  if (contact == Contact::hard)
    require_interior(problem, "smoothed friction' with 'Contact = hard");
  SmoothedFrictionProgram program(problem, contact, controls, barrier_parameter,
                                  terminal);
  IpoptControls ipopt = {controls.tolerance, controls.n_max_iterations};
  if (contact == Contact::compliant)
    ipopt.tolerance *= ipopt_over_own_tolerance;
  else
  {
    // Stop at a given point of the central path and not anywhere near its end:
    // the normal forces are then those of one barrier problem, to the solver's
    // precision, and do not depend on the steps that led there.
    ipopt.mu_target = barrier_parameter;
    ipopt.tolerance =
        std::min(ipopt.tolerance, tolerance_over_barrier * barrier_parameter);
  }

  Solution solution = program.solve(ipopt);
  solution.displacement_unit *= smoothing_length;
  return solution;
}
} // namespace Voussoir
