// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_energy_minimise_h
#define voussoir_statics_energy_minimise_h

#include <voussoir/algebra/newton.h>
#include <voussoir/statics/problem/shared_problem.h>
#include <voussoir/terminal/terminal.h>

#include <functional>
#include <limits>
#include <optional>

namespace Voussoir
{
/** The stopping criteria of Newton's method; see minimise(). */
struct NewtonControls
{
  /** The largest imbalance. */
  double imbalance;
  /** The largest number of steps. */
  unsigned int n_max_iterations;
  /** The largest decrement of the last step. */
  double decrement = std::numeric_limits<double>::infinity();
  /** The largest change of a force in the last step. */
  double force_change = std::numeric_limits<double>::infinity();
};

/** The imbalance below which Newton's method converges. */
inline constexpr double imbalance_without_doubt = 1e-4;

/**
 * Whether the load may be so near its limit, or beyond, that Newton's steps
 * walk from hinge to hinge, or from one joint that slides to the next
 * (measured, random packings: up to 300 steps): the imbalance is large after
 * eight steps, or hardly less than the first one after three or more.
 */
bool is_in_doubt(const Newton &newton, double first_imbalance);

/**
 * Call @p advance, which takes a step and may return a proof of collapse found
 * otherwise, until the controls are met, the displacement proves that there is
 * no minimum, or there is no progress; then say what was found. It has
 * converged in the first case.
 *
 * @param problem shares out and collects.
 * @param newton at its start.
 * @param controls say when to stop.
 * @param advance takes a step of @p newton.
 * @param terminal sees the iterations.
 * @return the state with the least imbalance that was met, on the root; without
 *   forces on the others.
 * @throws SolverError as Newton::step() does.
 */
Solution minimise(const SharedProblem &problem,
                  Newton &newton,
                  const NewtonControls &controls,
                  const std::function<std::optional<Mechanism>()> &advance,
                  Terminal &terminal);
} // namespace Voussoir

#endif
