// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/convex_program.h>
#include <voussoir/base/text.h>
#include <voussoir/parallel/begin_mpi.h>

#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>

#include <algorithm>
#include <exception>
#include <mpi.h>
#include <mutex>
#include <new>
#include <utility>

namespace Voussoir
{
namespace
{
/** The value that Ipopt takes for infinite. */
constexpr double ipopt_infinity = 1e20;

/**
 * With loose unknowns: with MUMPS' own, 1e-6, strengths
 * below 1e-6 of the load cost half the digits of the forces. Elsewhere it is
 * the better one (measured).
 */
constexpr double pivot_tolerance_of_loose_unknowns = 1e-4;

/**
 * The shift of the second derivatives of loose unknowns, which may change
 * without any constraint noticing. It changes steps, not minima, and is far
 * below the stiffness of a contact that is pressed.
 */
constexpr double shift_of_loose_unknowns = 1e-6;

/** A ConvexProgram in the form that Ipopt asks for. */
class Adapter : public Ipopt::TNLP
{
public:
  using Index = Ipopt::Index;
  using Number = Ipopt::Number;
  using Entry = ConvexProgram::Entry;

  Adapter(ConvexProgram &program,
          std::vector<double> start,
          const IpoptControls &controls,
          const IpoptStop &stops,
          Terminal &terminal)
      : program(program), start(std::move(start)), controls(controls),
        stops(stops), terminal(terminal), constraints(program.constraints())
  {}

  IpoptResult result;
  /** True if the caller, rather than Ipopt, ended the search. */
  bool is_stopped = false;

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
    for (const unsigned int k : controls.held)
      x_lower[k] = x_upper[k] = start[k];
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

  bool eval_f(Index n, const Number *x, bool, Number &value) override
  {
    latest.assign(x, x + n);
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
      is_stopped = stops(result.n_iterations, latest);
    }
    catch (...)
    {
      exception = std::current_exception();
      return false;
    }
    return !is_stopped;
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

private:
  std::vector<Entry> hessian(const double *x) const
  {
    std::vector<Entry> entries = program.hessian(x);
    for (const unsigned int k : controls.loose)
      entries.push_back({k, k, shift_of_loose_unknowns});
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

  ConvexProgram &program;
  const std::vector<double> start;
  const IpoptControls &controls;
  const IpoptStop &stops;
  Terminal &terminal;
  const std::vector<Entry> constraints;
  /** The last unknowns that Ipopt tried. */
  std::vector<double> latest;
};

IpoptOutcome outcome_of(const Ipopt::ApplicationReturnStatus status)
{
  switch (status)
  {
  case Ipopt::Solve_Succeeded: return IpoptOutcome::converged;
  case Ipopt::Solved_To_Acceptable_Level: return IpoptOutcome::looser_tolerance;
  case Ipopt::Search_Direction_Becomes_Too_Small: return IpoptOutcome::rounding;
  case Ipopt::Maximum_Iterations_Exceeded: return IpoptOutcome::most_iterations;
  case Ipopt::Diverging_Iterates: return IpoptOutcome::diverged;
  case Ipopt::Restoration_Failed: return IpoptOutcome::infeasible;
  case Ipopt::Error_In_Step_Computation: return IpoptOutcome::no_step;
  default: return IpoptOutcome::other;
  }
}
} // namespace

IpoptResult solve_with_ipopt(ConvexProgram &program,
                             std::vector<double> start,
                             const IpoptControls &controls,
                             const IpoptStop &stops,
                             Terminal &terminal)
{
  // MUMPS keeps its state in variables of the whole program.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  begin_mpi();
  const Ipopt::SmartPtr<Adapter> adapter =
      new Adapter(program, std::move(start), controls, stops, terminal);
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> ipopt =
      IpoptApplicationFactory();
  const Ipopt::SmartPtr<Ipopt::OptionsList> options = ipopt->Options();
  options->SetIntegerValue("print_level", terminal.verbosity() >= 2 ? 5 : 0);
  options->SetStringValue("sb", "yes"); // no banner
  options->SetStringValue("linear_solver", "mumps");
  // A MUMPS with MPI, as Debian 13's, would want all processes.
  const std::string communicator = "mumps_mpi_communicator";
  if (Ipopt::IsValid(ipopt->RegOptions()->GetOption(communicator)))
    options->SetIntegerValue(communicator, MPI_Comm_c2f(MPI_COMM_SELF));
  if (!controls.loose.empty())
    options->SetNumericValue("mumps_pivtol", pivot_tolerance_of_loose_unknowns);
  options->SetStringValue("nlp_scaling_method", "none");
  options->SetStringValue("jac_d_constant", "yes");
  options->SetNumericValue("tol", controls.tolerance);
  options->SetIntegerValue("max_iter", controls.n_max_iterations);
  // Convergence is judged by the certificate, so no looser tolerance.
  options->SetIntegerValue("acceptable_iter", 0);
  options->SetNumericValue("mu_target", controls.mu_target);
  options->SetNumericValue("kappa_d", controls.damping);
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
      adapter->is_stopped ? IpoptOutcome::stopped : outcome_of(status);
  result.status = status;
  return result;
}
} // namespace Voussoir
