// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_problem_formulation_h
#define voussoir_statics_problem_formulation_h

#include <voussoir/statics/problem/discrete_problem.h>
#include <voussoir/statics/problem/solution.h>
#include <voussoir/statics/problem/solver_controls.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace Voussoir
{
/**
 * A way to select one of the admissible and balanced states of the interface
 * forces, which in general are many.
 */
class Formulation
{
public:
  virtual ~Formulation() = default;

  /** The name in `set Formulation = ...`; also that of its subsection. */
  virtual std::string name() const = 0;
  /** One line on it, for the documentation of the parameters. */
  virtual std::string meaning() const = 0;
  /**
   * The principle by which the state was selected, with the present parameters.
   */
  virtual std::string selection() const = 0;

  /** Declare the parameters in the current subsection and bind them, if any. */
  virtual void add_parameters(dealii::ParameterHandler & /*prm*/) {}

  /**
   * Find the forces, or the proof that there are none.
   *
   * The forces of a solution that has not converged() are for certify() to
   * judge.
   *
   * @throws InputError if the formulation needs a motion that opens all
   * contacts and there is none; see require_interior().
   * @throws SolverError if the solver ends with neither.
   */
  Solution solve(const DiscreteProblem &problem,
                 const SolverControls &controls,
                 Terminal &terminal) const;

private:
  /** Solution::displacement_unit; zero if it has no displacement of its own. */
  virtual double displacement_unit(const DiscreteProblem & /*problem*/) const
  {
    return 0.;
  }
  /** solve() for a problem with interfaces and a load. */
  virtual Solution select(const DiscreteProblem &problem,
                          const SolverControls &controls,
                          Terminal &terminal) const = 0;
};

/**
 * Refuse a packing that is clamped, in the name of a @p formulation that has no
 * answer there.
 *
 * @throws InputError if no motion opens all contacts of @p problem; see
 *   opening_of().
 */
void require_interior(const DiscreteProblem &problem,
                      const std::string &formulation);

/** Correct the forces of @p solution by equilibrate(), and say by how much. */
void equilibrate_solution(const DiscreteProblem &problem, Solution &solution);
} // namespace Voussoir

#endif
