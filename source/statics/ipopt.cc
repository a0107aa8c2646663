// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/convex_program.h>
#include <voussoir/statics/find_collapse.h>

#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

namespace Voussoir
{
namespace
{
/** What Ipopt takes for infinite. */
constexpr double ipopt_infinity = 1e20;

/**
 * For bodies that hardly any friction holds: with MUMPS' own, 1e-6, strengths
 * below 1e-6 of the load cost half the digits of the forces. Elsewhere it is
 * the better one (measured).
 */
constexpr double pivot_tolerance_of_loose_bodies = 1e-4;

/**
 * What is added to the second derivatives of bodies that hardly any friction
 * holds, and that may move without any joint noticing. It changes steps, not
 * minima, and is far below the stiffness of a contact that is pressed.
 */
constexpr double shift_of_loose_bodies = 1e-6;
/** The strength s_e, nondimensional, that is hardly any. */
constexpr double hardly_any_strength = 1e-4;

/** After how many iterations the load may be one that is not carried. */
constexpr unsigned int n_before_doubt = 25;

/** A ConvexProgram in the form that Ipopt asks for. */
class Adapter : public Ipopt::TNLP
{
public:
  using Index = Ipopt::Index;
  using Number = Ipopt::Number;
  using Entry = ConvexProgram::Entry;

  Adapter(const DiscreteProblem &problem,
          ConvexProgram &program,
          Terminal &terminal)
      : problem(problem), program(program), terminal(terminal),
        start(program.start()), constraints(program.constraints())
  {
    hold_bodies();
    find_loose_bodies();
  }

  /** Whether hardly any friction holds some body. */
  bool has_loose_bodies() const
  {
    return !loose_bodies.empty();
  }

  IpoptResult result;
  /** Why this class or the program, rather than Ipopt, ended the search. */
  std::string stop_reason;

  /** Ipopt takes every exception for its own failure: keep it. */
  std::exception_ptr exception;

  bool get_nlp_info(Index &n,
                    Index &m,
                    Index &nnz_jac,
                    Index &nnz_hessian,
                    IndexStyleEnum &index_style) override
  {
    n = start.size();
    m = program.n_constraints();
    nnz_jac = constraints.size();
    nnz_hessian = hessian(start.data()).size();
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
    for (unsigned int b = 0; b < problem.n_bodies(); ++b)
      if (problem.is_held(b))
        for (unsigned int i = 0; i < 2; ++i)
        {
          const unsigned int k = problem.dof(b, i);
          x_lower[k] = x_upper[k] = start[k];
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
    std::copy(start.begin(), start.end(), x);
    if (init_lambda)
      std::fill_n(lambda, m, 0.);
    return true;
  }

  bool eval_f(Index, const Number *x, bool, Number &value) override
  {
    latest.assign(x, x + problem.n_dofs());
    ++result.n_evaluations;
    value = program.value(x);
    return true;
  }

  bool eval_grad_f(Index, const Number *x, bool, Number *gradient) override
  {
    const std::vector<double> values = program.gradient(x);
    std::copy(values.begin(), values.end(), gradient);
    return true;
  }

  bool eval_g(Index, const Number *x, bool, Index m, Number *g) override
  {
    std::fill_n(g, m, 0.);
    for (const Entry &entry : constraints)
      g[entry.row] += entry.value * x[entry.column];
    return true;
  }

  bool eval_jac_g(Index,
                  const Number *,
                  bool,
                  Index,
                  Index,
                  Index *rows,
                  Index *columns,
                  Number *values) override
  {
    fill(constraints, 1., rows, columns, values);
    return true;
  }

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
    fill(hessian(values == nullptr ? start.data() : x), objective_factor, rows,
         columns, values);
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
    result.n_iterations = iteration;
    terminal.progress(text("iteration ", iteration, ", imbalance ", inf_du,
                           ", interpenetration ", inf_pr));
    try
    {
      result.mechanism = find_mechanism(problem, latest);
      if (!result.mechanism && !asked && result.n_iterations >= n_before_doubt)
      {
        asked = true;
        result.mechanism = find_collapse(SharedProblem(problem), terminal);
      }
      if (!result.mechanism)
        stop_reason = program.verdict(iteration);
    }
    catch (...)
    {
      exception = std::current_exception();
      return false;
    }
    return !result.mechanism && stop_reason.empty();
  }

  void finalize_solution(Ipopt::SolverReturn,
                         Index n,
                         const Number *x,
                         const Number *,
                         const Number *,
                         Index m,
                         const Number *,
                         const Number *lambda,
                         Number,
                         const Ipopt::IpoptData *,
                         Ipopt::IpoptCalculatedQuantities *) override
  {
    result.x.assign(x, x + n);
    result.multipliers.assign(lambda, lambda + m);
  }

  /** Whether find_collapse() has had its say. */
  bool asked = false;

private:
  /**
   * Move each connected group so that the body that is held starts at zero:
   * close to the end displacements may be many orders smaller than those of the
   * start, and their differences would lose digits to a common translation.
   */
  void hold_bodies()
  {
    std::vector<double> u(start.begin(), start.begin() + problem.n_dofs());
    problem.hold_bodies(u);
    std::copy(u.begin(), u.end(), start.begin());
  }

  void find_loose_bodies()
  {
    std::vector<bool> is_loose(problem.n_bodies(), true);
    for (const DiscreteProblem::Joint &joint : problem.joints())
      if (joint.strength > hardly_any_strength * joint.length)
        is_loose[joint.cell_minus] = is_loose[joint.cell_plus] = false;
    for (unsigned int b = 0; b < problem.n_bodies(); ++b)
      if (is_loose[b])
        loose_bodies.push_back(b);
  }

  std::vector<Entry> hessian(const double *x) const
  {
    std::vector<Entry> entries = program.hessian(x);
    for (const unsigned int b : loose_bodies)
      for (unsigned int i = 0; i < 2; ++i)
        entries.push_back(
            {problem.dof(b, i), problem.dof(b, i), shift_of_loose_bodies});
    return entries;
  }

  /** Hand over the places of the entries, or their values. */
  static void fill(const std::vector<Entry> &entries,
                   const double factor,
                   Index *rows,
                   Index *columns,
                   Number *values)
  {
    for (std::size_t k = 0; k < entries.size(); ++k)
      if (values == nullptr)
      {
        rows[k] = entries[k].row;
        columns[k] = entries[k].column;
      }
      else
        values[k] = factor * entries[k].value;
  }

  const DiscreteProblem &problem;
  ConvexProgram &program;
  Terminal &terminal;
  std::vector<double> start;
  const std::vector<Entry> constraints;
  std::vector<unsigned int> loose_bodies;
  /** The last displacement that Ipopt tried. */
  std::vector<double> latest;
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
    return text("ended with the status ", static_cast<int>(status));
  }
}
} // namespace

IpoptResult solve_with_ipopt(const DiscreteProblem &problem,
                             ConvexProgram &program,
                             const IpoptControls &controls,
                             Terminal &terminal)
{
  const Ipopt::SmartPtr<Adapter> adapter =
      new Adapter(problem, program, terminal);
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> ipopt =
      IpoptApplicationFactory();
  const Ipopt::SmartPtr<Ipopt::OptionsList> options = ipopt->Options();
  options->SetIntegerValue("print_level", terminal.verbosity() >= 2 ? 5 : 0);
  options->SetStringValue("sb", "yes"); // no banner
  options->SetStringValue("linear_solver", "mumps");
  if (adapter->has_loose_bodies())
    options->SetNumericValue("mumps_pivtol", pivot_tolerance_of_loose_bodies);
  options->SetStringValue("nlp_scaling_method", "none");
  options->SetStringValue("jac_d_constant", "yes");
  options->SetNumericValue("tol", controls.tolerance);
  options->SetIntegerValue("max_iter", controls.n_max_iterations);
  // Convergence is judged by the certificate, so no looser tolerance.
  options->SetIntegerValue("acceptable_iter", 0);
  options->SetNumericValue("mu_target", controls.mu_target);
  // Constraints hold as they are, not relaxed.
  options->SetNumericValue("bound_relax_factor", 0.);
  ipopt->Initialize("");

  const Ipopt::ApplicationReturnStatus status = ipopt->OptimizeTNLP(
      Ipopt::SmartPtr<Ipopt::TNLP>(Ipopt::GetRawPtr(adapter)));
  if (adapter->exception)
    std::rethrow_exception(adapter->exception);
  if (status == Ipopt::Insufficient_Memory)
    throw std::bad_alloc();
  IpoptResult result = adapter->result;
  result.outcome =
      adapter->stop_reason.empty() ? describe(status) : adapter->stop_reason;
  if (result.outcome != "converged" && !result.mechanism && !adapter->asked)
    result.mechanism = find_collapse(SharedProblem(problem), terminal);
  if (result.mechanism)
    result.outcome = "stopped by a proof of collapse";
  else if (result.x.empty())
    throw SolverError("Ipopt " + result.outcome +
                      " before its first iteration. Try 'Formulation = least "
                      "energy', which does without Ipopt.");
  return result;
}

Solution make_solution(const DiscreteProblem &problem, IpoptResult result)
{
  Solution solution;
  solution.mechanism = std::move(result.mechanism);
  solution.n_iterations = result.n_iterations;
  solution.n_evaluations = result.n_evaluations;
  solution.outcome = std::move(result.outcome);
  solution.displacement.resize(problem.n_cells());
  return solution;
}
} // namespace Voussoir
