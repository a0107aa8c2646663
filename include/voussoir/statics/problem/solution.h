// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_problem_solution_h
#define voussoir_statics_problem_solution_h

#include <voussoir/statics/problem/mechanism.h>
#include <voussoir/statics/problem/stop.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** The passes of a fixed point. */
struct Passes
{
  /** Their number; zero if there is no fixed point. */
  unsigned int n = 0;
  /** The last change over the one before. */
  double rate = 0.;
};

/** The result of a formulation. */
struct Solution
{
  /**
   * Of each row of each joint, as in Structure; nondimensional, see
   * dimensional_forces().
   */
  std::vector<double> forces;
  /**
   * The largest change of a force by equilibrate(), over the largest force
   * before or after.
   */
  std::optional<double> correction;
  /**
   * The displacement, n_dofs() numbers, nondimensional: from the ground, or
   * with zero mean in each connected group of cells that does not rest on it;
   * possibly empty. See dimensional_motion().
   */
  std::vector<double> u;
  /**
   * The unit of that, L, which the formulation chooses. Zero where it has no
   * displacement of its own: blocks that carry their load do not move.
   */
  double displacement_unit = 0.;
  /** @{ */
  /**
   * Joints in which every admissible and balanced state has f_e^n = 0, and
   * |f_e^t| = s_e |e|; empty if the formulation does not find out.
   */
  std::vector<bool> never_pressed, always_sliding;
  /** @} */
  /** The proof that the load is not carried; then nothing above counts. */
  std::optional<Mechanism> mechanism;
  /** The number of the solver's iterations. */
  unsigned int n_iterations = 0;
  /** Of CoulombState. */
  Passes passes = {};
  /** The number of evaluations of the energy or the forces by the solver. */
  unsigned int n_evaluations = 0;
  /** The wall time of parts of the solution, by name; seconds. */
  std::map<std::string, double> seconds;
  /** The reason for which the solver stopped. */
  Stop stop;
  /** How it was selected, if not as the formulation says. */
  std::string selection;

  /** True if the solver met its tolerance. */
  bool converged() const { return stop == Stop::Reason::converged; }
};
} // namespace Voussoir

#endif
