// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/smoothed_friction.h>
#include <voussoir/statics/smoothed_joint.h>

#include <IpIpoptApplication.hpp>
#include <IpIpoptCalculatedQuantities.hpp>
#include <IpIpoptData.hpp>
#include <IpTNLP.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
using dealii::Tensor;

namespace
{
using Joint = DiscreteProblem::Joint;
using Jump = DiscreteProblem::Jump;

/** What Ipopt takes for infinite. */
constexpr double ipopt_infinity = 1e20;

/**
 * The product of normal force and opening, nondimensional, at which hard
 * contact stops: near enough to zero not to move the forces, far enough above
 * the solver's tolerance for the product to be met in every joint.
 */
constexpr double central_path_parameter = 1e-8;

/**
 * With compliant contact the balance of all cells decides when to stop. Ipopt
 * does not see that of the cells held in place, where the imbalance of all
 * others adds up, and must not stop before.
 */
constexpr double ipopt_over_own_tolerance = 1e-3;

/**
 * How many iterations without a better balance of forces end the search: at the
 * very limit of the load the displacements grow until rounding takes over.
 */
constexpr unsigned int n_stalled_iterations = 20;

/** The problem as Ipopt asks for it; the unknowns are those of the problem. */
class SmoothedProgram : public Ipopt::TNLP
{
public:
  using Index = Ipopt::Index;
  using Number = Ipopt::Number;

  SmoothedProgram(const DiscreteProblem &problem,
                  const Contact contact,
                  const double tolerance,
                  Terminal &terminal)
      : problem(problem), contact(contact), law(problem, contact),
        tolerance(tolerance), terminal(terminal)
  {
  }

  /** What Ipopt found; filled when it ends. */
  Solution solution;
  /** Why this program, rather than Ipopt, ended the search. */
  std::string stop_reason;

  bool get_nlp_info(Index &n,
                    Index &m,
                    Index &nnz_jac,
                    Index &nnz_hessian,
                    IndexStyleEnum &index_style) override
  {
    const Index n_joints = problem.joints().size();
    n = problem.n_dofs();
    m = n_constraints();
    nnz_jac = 4 * m;
    nnz_hessian = 3 * problem.n_cells() + 4 * n_joints;
    index_style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n,
                       Number *x_lower,
                       Number *x_upper,
                       Index m,
                       Number *g_lower,
                       Number *g_upper) override
  {
    std::fill_n(x_lower, n, -ipopt_infinity);
    std::fill_n(x_upper, n, ipopt_infinity);
    // The forces do not change with a translation: hold one cell per group.
    for (unsigned int c = 0; c < problem.n_cells(); ++c)
      if (problem.groups()[c] == c)
        for (unsigned int i = 0; i < 2; ++i)
        {
          const unsigned int k = problem.dof(c, i);
          x_lower[k] = x_upper[k] = start(c, i);
        }
    std::fill_n(g_lower, m, 0.);
    std::fill_n(g_upper, m, ipopt_infinity);
    return true;
  }

  bool get_starting_point(Index,
                          bool,
                          Number *x,
                          bool,
                          Number *,
                          Number *,
                          Index m,
                          bool init_lambda,
                          Number *lambda) override
  {
    for (unsigned int c = 0; c < problem.n_cells(); ++c)
      for (unsigned int i = 0; i < 2; ++i)
        x[problem.dof(c, i)] = start(c, i);
    if (init_lambda)
      std::fill_n(lambda, m, 0.);
    return true;
  }

  bool eval_f(Index n, const Number *x, bool, Number &value) override
  {
    latest.assign(x, x + n);
    ++solution.n_evaluations;
    // Close to the minimum the line search compares energies that differ by
    // rounding alone; a longer sum keeps it from cutting good steps.
    long double sum = -problem.work(x);
    for (const Joint &joint : problem.joints())
      sum += law.energy(joint, problem.jump(joint, x));
    value = sum;
    return true;
  }

  bool eval_grad_f(Index n, const Number *x, bool, Number *gradient) override
  {
    std::fill_n(gradient, n, 0.);
    for (unsigned int c = 0; c < problem.n_cells(); ++c)
      for (unsigned int i = 0; i < 2; ++i)
        gradient[problem.dof(c, i)] = -problem.loads()[c][i];
    for (const Joint &joint : problem.joints())
      problem.add_jump_gradient(joint, law.force(joint, problem.jump(joint, x)),
                                gradient);

    // Without constraints the gradient is the imbalance of the forces.
    if (contact == Contact::compliant)
    {
      double imbalance = 0.;
      for (Index k = 0; k < n; ++k)
        imbalance = std::max(imbalance, std::abs(gradient[k]));
      if (imbalance < least_imbalance)
      {
        least_imbalance = imbalance;
        most_balanced.assign(x, x + n);
        most_balanced_iteration = solution.n_iterations;
      }
    }
    return true;
  }

  bool eval_g(Index, const Number *x, bool, Index m, Number *g) override
  {
    for (Index e = 0; e < m; ++e)
      g[e] = problem.jump(problem.joints()[e], x).normal;
    return true;
  }

  bool eval_jac_g(Index,
                  const Number *,
                  bool,
                  Index m,
                  Index,
                  Index *rows,
                  Index *columns,
                  Number *values) override
  {
    for (Index e = 0, k = 0; e < m; ++e)
    {
      const Joint &joint = problem.joints()[e];
      for (unsigned int i = 0; i < 2; ++i)
        for (const bool plus : {false, true})
        {
          if (values == nullptr)
          {
            rows[k] = e;
            columns[k] =
                problem.dof(plus ? joint.cell_plus : joint.cell_minus, i);
          }
          else
            values[k] = plus ? joint.normal[i] : -joint.normal[i];
          ++k;
        }
    }
    return true;
  }

  // The lower triangle: first the three entries of each cell's diagonal block,
  // then the four of each joint's block (c+, c-); c- < c+.
  bool eval_h(Index,
              const Number *x,
              bool,
              Number objective_factor,
              Index,
              const Number *,
              bool,
              Index,
              Index *rows,
              Index *columns,
              Number *values) override
  {
    if (values == nullptr)
      hessian_pattern(rows, columns);
    else
      hessian_values(x, objective_factor, values);
    return true;
  }

  bool intermediate_callback(Ipopt::AlgorithmMode,
                             Index iteration,
                             Number,
                             Number inf_pr,
                             Number inf_du,
                             Number,
                             Number,
                             Number,
                             Number,
                             Number,
                             Index,
                             const Ipopt::IpoptData *,
                             Ipopt::IpoptCalculatedQuantities *) override
  {
    solution.n_iterations = iteration;
    terminal.progress("Ipopt", text("iteration ", iteration, ", imbalance ",
                                    inf_du, ", interpenetration ", inf_pr));
    solution.mechanism = find_mechanism(problem, latest);
    if (solution.mechanism)
    {
      stop_reason = "stopped by a proof of collapse";
      return false;
    }
    if (contact == Contact::compliant && least_imbalance <= tolerance)
    {
      stop_reason = "converged";
      return false;
    }
    if (contact == Contact::compliant &&
        solution.n_iterations > most_balanced_iteration + n_stalled_iterations)
    {
      stop_reason = "stopped at the limit of rounding";
      return false;
    }
    return true;
  }

  void finalize_solution(Ipopt::SolverReturn,
                         Index,
                         const Number *last_x,
                         const Number *,
                         const Number *,
                         Index m,
                         const Number *,
                         const Number *lambda,
                         Number,
                         const Ipopt::IpoptData *,
                         Ipopt::IpoptCalculatedQuantities *) override
  {
    const Number *x = most_balanced.empty() ? last_x : most_balanced.data();
    const unsigned int n_joints = problem.joints().size();
    solution.forces.normal.resize(n_joints);
    solution.forces.tangential.resize(n_joints);
    for (unsigned int e = 0; e < n_joints; ++e)
    {
      const Joint &joint = problem.joints()[e];
      const Jump force = law.force(joint, problem.jump(joint, x));
      // Ipopt's multiplier of y_e >= 0 is -p_e, which is f_e^n.
      solution.forces.normal[e] = m > 0 ? lambda[e] : force.normal;
      solution.forces.tangential[e] = force.tangential;
    }
    solution.displacement.resize(problem.n_cells());
    for (unsigned int c = 0; c < problem.n_cells(); ++c)
      for (unsigned int i = 0; i < 2; ++i)
        solution.displacement[c][i] =
            x[problem.dof(c, i)] / law.displacement_unit();
  }

private:
  Index n_constraints() const
  {
    return contact == Contact::hard ? problem.joints().size() : 0;
  }

  /** Hard contact starts from the dilation, which opens every joint. */
  double start(const unsigned int c, const unsigned int i) const
  {
    return contact == Contact::hard ? problem.centres()[c][i] : 0.;
  }

  void hessian_pattern(Index *rows, Index *columns) const
  {
    unsigned int k = 0;
    for (unsigned int c = 0; c < problem.n_cells(); ++c)
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j <= i; ++j, ++k)
        {
          rows[k] = problem.dof(c, i);
          columns[k] = problem.dof(c, j);
        }
    for (const Joint &joint : problem.joints())
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j, ++k)
        {
          rows[k] = problem.dof(joint.cell_plus, i);
          columns[k] = problem.dof(joint.cell_minus, j);
        }
  }

  void
  hessian_values(const Number *x, const Number factor, Number *values) const
  {
    Number *of_cells = values;
    Number *of_joints = values + 3 * problem.n_cells();
    std::fill_n(of_cells, 3 * problem.n_cells(), 0.);
    for (const Joint &joint : problem.joints())
    {
      const Jump second = law.second_derivative(joint, problem.jump(joint, x));
      unsigned int k = 0;
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
        {
          const Number block =
              factor *
              (second.normal * joint.normal[i] * joint.normal[j] +
               second.tangential * joint.tangent[i] * joint.tangent[j]);
          *of_joints++ = -block;
          if (j <= i)
          {
            of_cells[3 * joint.cell_minus + k] += block;
            of_cells[3 * joint.cell_plus + k] += block;
            ++k;
          }
        }
    }
  }

  const DiscreteProblem &problem;
  const Contact contact;
  const SmoothedJoint law;
  const double tolerance;
  Terminal &terminal;
  /** The last point that Ipopt tried. */
  std::vector<double> latest;
  /** Of the points of compliant contact, the one with the best balance. */
  std::vector<double> most_balanced;
  double least_imbalance = std::numeric_limits<double>::infinity();
  unsigned int most_balanced_iteration = 0;
};

std::string describe(const Ipopt::ApplicationReturnStatus status)
{
  switch (status)
  {
  case Ipopt::Solve_Succeeded:
    return "converged";
  case Ipopt::Solved_To_Acceptable_Level:
    return "stopped at a looser tolerance";
  case Ipopt::Search_Direction_Becomes_Too_Small:
    return "stopped at the limit of rounding";
  case Ipopt::Maximum_Iterations_Exceeded:
    return "reached 'Solver/Maximum iterations'";
  case Ipopt::Diverging_Iterates:
    return "diverged";
  case Ipopt::Restoration_Failed:
    return "failed to restore feasibility";
  case Ipopt::Error_In_Step_Computation:
    return "failed to compute a step";
  default:
    return text("ended with Ipopt's status ", static_cast<int>(status));
  }
}
} // namespace

std::string SmoothedFriction::name() const
{
  return "smoothed friction";
}

std::string SmoothedFriction::meaning() const
{
  return "the displacement problem with |.| smoothed, solved by Ipopt.";
}

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
}

Solution SmoothedFriction::select(const DiscreteProblem &problem,
                                  const SolverControls &controls,
                                  Terminal &terminal) const
{
  const Ipopt::SmartPtr<SmoothedProgram> program =
      new SmoothedProgram(problem, contact, controls.tolerance, terminal);
  Solution &solution = program->solution;

  const Ipopt::SmartPtr<Ipopt::IpoptApplication> ipopt =
      IpoptApplicationFactory();
  const Ipopt::SmartPtr<Ipopt::OptionsList> options = ipopt->Options();
  options->SetIntegerValue("print_level", terminal.verbosity() >= 2 ? 5 : 0);
  options->SetStringValue("sb", "yes"); // no banner
  options->SetStringValue("linear_solver", "mumps");
  options->SetStringValue("nlp_scaling_method", "none");
  options->SetStringValue("jac_d_constant", "yes");
  options->SetNumericValue(
      "tol", controls.tolerance *
                 (contact == Contact::hard ? 1. : ipopt_over_own_tolerance));
  options->SetIntegerValue("max_iter", controls.n_max_iterations);
  // Convergence is judged by the certificate, so no looser tolerance.
  options->SetIntegerValue("acceptable_iter", 0);
  // Stop at a given point of the central path and not anywhere near its end:
  // the normal forces are then those of one barrier problem, to the solver's
  // precision, and do not depend on the steps that led there.
  options->SetNumericValue("mu_target", central_path_parameter);
  // Constraints hold as they are, not relaxed.
  options->SetNumericValue("bound_relax_factor", 0.);
  ipopt->Initialize("");

  const Ipopt::ApplicationReturnStatus status = ipopt->OptimizeTNLP(
      Ipopt::SmartPtr<Ipopt::TNLP>(Ipopt::GetRawPtr(program)));
  solution.outcome =
      program->stop_reason.empty() ? describe(status) : program->stop_reason;
  if (!solution.mechanism)
  {
    if (solution.displacement.empty())
      throw SolverError("Ipopt " + solution.outcome + ".");
    problem.remove_group_means(solution.displacement);
    for (Tensor<1, 2> &u : solution.displacement)
      u *= smoothing_length;
  }
  return solution;
}
} // namespace Voussoir
