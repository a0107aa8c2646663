// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_convex_program_h
#define voussoir_statics_convex_program_h

#include <voussoir/base/terminal.h>
#include <voussoir/statics/solution.h>

#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/**
 * A convex function f of x to be minimised under G x >= 0, where x begins with
 * the displacements of a DiscreteProblem (n_dofs() numbers) and may go on with
 * other unknowns.
 */
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
    /** What is added to other entries of that place. */
    double value;
  };

  virtual ~ConvexProgram() = default;

  /** Where to begin; as many numbers as there are unknowns. */
  virtual std::vector<double> start() const = 0;

  /** f(x), for as many numbers @p x as start() has. */
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

  /** Why to stop after @p iteration; empty to go on. */
  virtual std::string verdict(unsigned int /*iteration*/)
  {
    return {};
  }
};

/** What Ipopt is told. */
struct IpoptControls
{
  /** Ipopt's own, of its optimality conditions; nondimensional. */
  double tolerance;
  /** After so many iterations Ipopt gives up. */
  unsigned int n_max_iterations;
  /** The product of each constraint and its multiplier to stop at. */
  double mu_target = 0.;
};

/** What Ipopt found. */
struct IpoptResult
{
  /** The unknowns, where Ipopt stopped. */
  std::vector<double> x;
  /**
   * Of each constraint, not positive.
   *
   * That of [u]_e . n_e >= 0 is f_e^n = -p_e.
   */
  std::vector<double> multipliers;
  /** The proof, if there is one, that there is no minimum. */
  std::optional<Mechanism> mechanism;
  /** The number of Ipopt's iterations. */
  unsigned int n_iterations = 0;
  /** How often value() was asked for. */
  unsigned int n_evaluations = 0;
  /** Why it stopped, in a few words; "converged" if it did. */
  std::string outcome;
};

/**
 * Solve @p program with Ipopt and MUMPS. In each connected group of cells one
 * is held where it starts, since a translation changes nothing. The iterates
 * are watched for mechanisms; after many iterations without a minimum
 * find_collapse() is asked.
 *
 * @param problem whose displacements are the first unknowns.
 * @param program to be solved.
 * @param controls of Ipopt.
 * @param terminal sees the iterations.
 * @throws SolverError if Ipopt ends without a point and without a mechanism.
 * @throws std::bad_alloc if it has not enough memory.
 */
IpoptResult solve_with_ipopt(const DiscreteProblem &problem,
                             ConvexProgram &program,
                             const IpoptControls &controls,
                             Terminal &terminal);

/** A solution without its forces, and with displacement zero. */
Solution make_solution(const DiscreteProblem &problem, IpoptResult result);
} // namespace Voussoir

#endif
