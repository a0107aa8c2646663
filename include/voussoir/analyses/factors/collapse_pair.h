// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_factors_collapse_pair_h
#define voussoir_analyses_factors_collapse_pair_h

#include <voussoir/statics/problem/discrete_problem.h>
#include <voussoir/terminal/terminal.h>

#include <vector>

namespace Voussoir
{
/**
 * A collapse with Coulomb's friction without dilatancy: forces within the cones
 * of friction that balance the loads at a factor, which is the greatest with
 * the strengths c_e |e| + mu_e p_e that they give to their own joints. So there
 * is a motion of the blocks that closes no joint and slides along joints, only
 * where friction is at its limit and against it.
 *
 * There may be many, at factors that differ.
 */
struct CollapsePair
{
  /** The factor. */
  double alpha = 0.;
  /** Of each row of each joint, nondimensional. */
  std::vector<double> forces;
  /** The motion, n_dofs() numbers, of which the largest is one. */
  std::vector<double> u;
  /** True if it is one; otherwise the sequence has not ended there. */
  bool is_found = false;
  /** The number of programmes. */
  unsigned int n_programmes = 0;
  /** The number of iterations in them. */
  unsigned int n_iterations = 0;
};

/**
 * Find a collapse by sequences of programmes with Tresca's friction, of which
 * each has the strengths that the normal forces of the one before give:
 * Gilbert, Casapulla and Ahmed, *Computers and Structures* 84 (2006), 873. Of
 * many optima each takes the one whose normal forces are closest to those
 * before, by
 *
 *     maximise  sense alpha - delta sum_e c_e^n sum_k (p_k - p_k^0)^2 / 2,
 *
 * whose last term vanishes where a sequence ends. Sequences start from the
 * forces that are given, and from those with dilatancy that have the least
 * pressures; the next strengths are by Anderson, or where that does not end, by
 * the step of Irons and Tuck. Of the collapses that are found this is the one
 * with the most extreme factor.
 *
 * @param problem with coefficients of friction.
 * @param dead, live the loads, n_dofs() numbers, of about one size.
 * @param sense 1 for great factors, -1 for small ones.
 * @param forces of each row of each joint to start from: those at the factor
 *   with dilatancy.
 * @param alpha this factor.
 * @param n_max_iterations in all programmes together.
 * @param terminal sees the programmes.
 */
CollapsePair find_collapse_pair(const DiscreteProblem &problem,
                                const std::vector<double> &dead,
                                const std::vector<double> &live,
                                double sense,
                                const std::vector<double> &forces,
                                double alpha,
                                unsigned int n_max_iterations,
                                Terminal &terminal);
} // namespace Voussoir

#endif
