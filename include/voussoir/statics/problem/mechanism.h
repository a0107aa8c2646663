// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_problem_mechanism_h
#define voussoir_statics_problem_mechanism_h

#include <voussoir/statics/problem/discrete_problem.h>

#include <optional>
#include <vector>

namespace Voussoir
{
/**
 * A motion of the blocks that opens or keeps every contact and in which the
 * load does more work than friction can dissipate.
 *
 * It is a proof that no admissible forces balance the load (the kinematic
 * theorem of limit analysis, Livesley, Int. J. Numer. Meth. Engng 12 (1978)
 * 1853).
 */
struct Mechanism
{
  /**
   * The displacement, n_dofs() numbers, without a common rigid motion in each
   * connected group that does not rest on the ground, which does not move; the
   * largest component is one. See dimensional_motion().
   */
  std::vector<double> u;
  /**
   * The work of the loads, nondimensional.
   *
   * It is sum_c F_c . u_c.
   */
  double work;
  /** What forces within their limits take out of it, nondimensional; less than
   * the work. In the plane it is dissipation_of(). */
  double dissipation;
};

/** The integral of the negative part of what is linear from a to b, over a
 * length of one. */
double negative_part(double a, double b);

/**
 * The most that forces within their limits take out of the displacement @p u
 * (n_dofs() numbers) in the plane, nondimensional: of friction, tension and
 * crushing. What closes or slides without a limit does not count.
 */
double dissipation_of(const DiscreteProblem &problem, const double *u);

/**
 * Look whether the displacement @p u (n_dofs() numbers, any size) proves that
 * the load is not carried. Where it closes joints it is first corrected by
 * opening_of(), which opens all of them; the correction's work
 * and dissipation are counted, so a mechanism that is returned is a proof.
 *
 * @return none if @p u proves nothing.
 */
std::optional<Mechanism> find_mechanism(const DiscreteProblem &problem,
                                        const std::vector<double> &u);

/**
 * Look for a mechanism where a displacement is close to one, where the load
 * does so little more work than friction dissipates that the correction would
 * cost more: joints that hardly move in it are kept from moving. It takes some
 * linear systems.
 */
std::optional<Mechanism> find_mechanism_near(const DiscreteProblem &problem,
                                             const std::vector<double> &u);
} // namespace Voussoir

#endif
