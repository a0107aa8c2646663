// SPDX-License-Identifier: LGPL-2.1-or-later
/*
 * Ipopt: none, no application; in solve status=N, what it says at the end, and
 * nan, inf, zero or wrong, what it hands over, of these no_unknowns and
 * no_multipliers; at_once=N, an end before it begins. MUMPS below it: status=N,
 * its INFOG(1); and in solutions nan, inf, zero or wrong.
 */
#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>

#include "plant.h"
#include <dmumps_c.h>
#include <new>
#include <vector>

namespace
{
using namespace Ipopt;

Plant::Function of_solve("solve");

/** A problem to which another solution is given than has been found. */
class SpoiltProblem : public TNLP
{
public:
  SpoiltProblem(const SmartPtr<TNLP> &problem, const char *failure)
      : problem(problem), failure(failure)
  {}
  bool get_nlp_info(Index &n,
                    Index &m,
                    Index &nnz_jac,
                    Index &nnz_hessian,
                    IndexStyleEnum &style) override
  {
    return problem->get_nlp_info(n, m, nnz_jac, nnz_hessian, style);
  }
  bool get_bounds_info(Index n,
                       Number *x_lower,
                       Number *x_upper,
                       Index m,
                       Number *g_lower,
                       Number *g_upper) override
  {
    return problem->get_bounds_info(n, x_lower, x_upper, m, g_lower, g_upper);
  }
  bool get_starting_point(Index n,
                          bool init_x,
                          Number *x,
                          bool init_z,
                          Number *z_lower,
                          Number *z_upper,
                          Index m,
                          bool init_lambda,
                          Number *lambda) override
  {
    return problem->get_starting_point(n, init_x, x, init_z, z_lower, z_upper,
                                       m, init_lambda, lambda);
  }
  bool eval_f(Index n, const Number *x, bool is_new, Number &value) override
  {
    return problem->eval_f(n, x, is_new, value);
  }
  bool
  eval_grad_f(Index n, const Number *x, bool is_new, Number *gradient) override
  {
    return problem->eval_grad_f(n, x, is_new, gradient);
  }
  bool
  eval_g(Index n, const Number *x, bool is_new, Index m, Number *g) override
  {
    return problem->eval_g(n, x, is_new, m, g);
  }
  bool eval_jac_g(Index n,
                  const Number *x,
                  bool is_new,
                  Index m,
                  Index n_entries,
                  Index *rows,
                  Index *columns,
                  Number *values) override
  {
    return problem->eval_jac_g(n, x, is_new, m, n_entries, rows, columns,
                               values);
  }
  bool eval_h(Index n,
              const Number *x,
              bool is_new,
              Number factor,
              Index m,
              const Number *lambda,
              bool new_lambda,
              Index n_entries,
              Index *rows,
              Index *columns,
              Number *values) override
  {
    return problem->eval_h(n, x, is_new, factor, m, lambda, new_lambda,
                           n_entries, rows, columns, values);
  }
  bool intermediate_callback(AlgorithmMode mode,
                             Index iteration,
                             Number objective,
                             Number inf_pr,
                             Number inf_du,
                             Number mu,
                             Number d_norm,
                             Number regularisation,
                             Number alpha_du,
                             Number alpha_pr,
                             Index n_trials,
                             const IpoptData *data,
                             IpoptCalculatedQuantities *quantities) override
  {
    return problem->intermediate_callback(
        mode, iteration, objective, inf_pr, inf_du, mu, d_norm, regularisation,
        alpha_du, alpha_pr, n_trials, data, quantities);
  }
  void finalize_solution(SolverReturn status,
                         Index n,
                         const Number *x,
                         const Number *z_lower,
                         const Number *z_upper,
                         Index m,
                         const Number *g,
                         const Number *lambda,
                         Number objective,
                         const IpoptData *data,
                         IpoptCalculatedQuantities *quantities) override
  {
    std::vector<Number> other_x(x, x + n), other_lambda(lambda, lambda + m);
    Plant::spoil(failure, other_x.data(), n);
    Plant::spoil(failure, other_lambda.data(), m);
    if (Plant::is(failure, "no_unknowns"))
      Plant::spoil("nan", other_x.data(), n);
    if (Plant::is(failure, "no_multipliers"))
      Plant::spoil("nan", other_lambda.data(), m);
    problem->finalize_solution(status, n, other_x.data(), z_lower, z_upper, m,
                               g, other_lambda.data(), objective, data,
                               quantities);
  }

private:
  const SmartPtr<TNLP> problem;
  const char *const failure;
};

class Application : public IpoptApplication
{
public:
  ApplicationReturnStatus OptimizeTNLP(const SmartPtr<TNLP> &problem) override
  {
    const char *const failure = of_solve.call();
    if (failure == nullptr)
      return IpoptApplication::OptimizeTNLP(problem);
    if (Plant::is(failure, "at_once"))
      return static_cast<ApplicationReturnStatus>(Plant::number_of(failure));
    const ApplicationReturnStatus status =
        IpoptApplication::OptimizeTNLP(new SpoiltProblem(problem, failure));
    return Plant::is(failure, "status")
               ? static_cast<ApplicationReturnStatus>(Plant::number_of(failure))
               : status;
  }
};
} // namespace

extern "C" {
Ipopt::IpoptApplication *IpoptApplicationFactory()
{
  static Plant::Function function("IpoptApplicationFactory");
  function.call();
  return new Application;
}

void dmumps_c(DMUMPS_STRUC_C *mumps)
{
  // The calls that Ipopt makes to factorise and to solve.
  static Plant::Function factorise("dmumps_factorise"), solve("dmumps_solve");
  static auto *const real = Plant::hidden<decltype(dmumps_c)>("dmumps_c");
  const char *const failure = mumps->job == 2   ? factorise.call()
                              : mumps->job == 3 ? solve.call()
                                                : nullptr;
  real(mumps);
  if (Plant::is(failure, "status"))
    mumps->infog[0] = Plant::number_of(failure);
  else if (failure != nullptr && mumps->rhs != nullptr)
    Plant::spoil(failure, mumps->rhs, mumps->n);
}
}
