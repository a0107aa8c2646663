// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_problem_solver_controls_h
#define voussoir_statics_problem_solver_controls_h

#include <voussoir/parallel/process_group.h>

namespace Voussoir
{
class Journal;
struct Solution;

/** The controls that all formulations share. */
struct SolverControls
{
  /** Largest force imbalance to stop at, nondimensional. */
  double tolerance = 1e-10;
  /** The largest number of iterations of a solver. */
  unsigned int n_max_iterations = 300;
  /** True if equilibrate() follows. */
  bool equilibrate = false;
  /** The largest distance of the bounds of a factor, over the factor. */
  double tolerance_of_factor = 1e-8;
  /**
   * The processes that can help; a formulation that cannot use them works on
   * the root alone.
   */
  ProcessGroup processes = ProcessGroup();
  /**
   * A solution whose displacement is near that of the solution, in units of its
   * own, or null. LeastEnergy starts from it, if it is alone.
   */
  const Solution *start = nullptr;
  /** Where is kept what is found on the way, or null. */
  Journal *journal = nullptr;
};

/** @{ */
/**
 * The number of iterations without a better balance of forces that end a
 * search, once it is this good, and rounding can be the reason: at the very
 * limit of the load the displacements grow until rounding takes over.
 */
inline constexpr unsigned int n_stalled_iterations = 20;
inline constexpr double imbalance_near_rounding = 1e-7;
/** @} */
} // namespace Voussoir

#endif
