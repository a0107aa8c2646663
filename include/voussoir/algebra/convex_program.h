// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_convex_program_h
#define voussoir_algebra_convex_program_h

#include <voussoir/terminal/terminal.h>

#include <functional>
#include <vector>

namespace Voussoir
{
/** A convex function f of x to be minimised under G x >= 0. */
class ConvexProgram
{
public:
  /** An entry of a sparse matrix. */
  struct Entry
  {
    /** @{ */
    /** Its place, counted from zero. */
    unsigned int row;
    unsigned int column;
    /** @} */
    /** Its value, added to those of other entries of that place. */
    double value;
  };

  virtual ~ConvexProgram() = default;

  /** f(x), for as many numbers @p x as there are unknowns. */
  virtual double value(const double *x) = 0;

  /** The derivative of f by each unknown. */
  virtual std::vector<double> gradient(const double *x) = 0;
  /**
   * The lower triangle of the second derivatives; entries of the same place add
   * up. The places are the same for all @p x.
   */
  virtual std::vector<Entry> hessian(const double *x) const = 0;

  /** The number of rows of G; none for a problem without constraints. */
  virtual unsigned int n_constraints() const = 0;

  /** The matrix G. */
  virtual std::vector<Entry> constraints() const = 0;
};

/** The controls of Ipopt. */
struct IpoptControls
{
  /** Ipopt's own, of its optimality conditions. */
  double tolerance;
  /** The largest number of iterations. */
  unsigned int n_max_iterations;
  /** The product of each constraint and its multiplier to stop at. */
  double mu_target = 0.;
  /**
   * Ipopt's kappa_d: constraints that nothing closes are pushed to by that
   * times the products, and stationarity is off by as much.
   */
  double damping = 1e-5;
  /** The unknowns that keep their values of the start. */
  std::vector<unsigned int> held = {};
  /** Unknowns that may change next to nothing else, neither f nor G x. */
  std::vector<unsigned int> loose = {};
};

/** True to stop Ipopt after so many iterations, at these unknowns. */
using IpoptStop =
    std::function<bool(unsigned int iteration, const std::vector<double> &x)>;

/** The reason for which Ipopt stopped. */
enum class IpoptOutcome
{
  converged,
  looser_tolerance,
  rounding,
  most_iterations,
  diverged,
  infeasible,
  no_step,
  /** By IpoptStop. */
  stopped,
  other
};

/** The result of Ipopt. */
struct IpoptResult
{
  /** The unknowns, where Ipopt stopped; empty if it had none. */
  std::vector<double> x;
  /** Of each constraint, not positive. */
  std::vector<double> multipliers;
  /** The number of Ipopt's iterations. */
  unsigned int n_iterations = 0;
  /** The number of calls of value(). */
  unsigned int n_evaluations = 0;
  /** The reason for which it stopped. */
  IpoptOutcome outcome = IpoptOutcome::other;
  /** The number that Ipopt has for the outcome. */
  int status = 0;
};

/**
 * Solve @p program with Ipopt and MUMPS.
 *
 * @param program to be solved.
 * @param start the starting point; as many numbers as there are unknowns.
 * @param controls of Ipopt.
 * @param stops is asked after each iteration; what it throws is thrown here.
 * @param terminal sees the iterations.
 * @throws std::bad_alloc if it has not enough memory.
 */
IpoptResult solve_with_ipopt(ConvexProgram &program,
                             std::vector<double> start,
                             const IpoptControls &controls,
                             const IpoptStop &stops,
                             Terminal &terminal);
} // namespace Voussoir

#endif
