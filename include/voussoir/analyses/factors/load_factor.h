// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_factors_load_factor_h
#define voussoir_analyses_factors_load_factor_h

#include <voussoir/base/journal.h>
#include <voussoir/scene/proofs/certificate.h>
#include <voussoir/scene/scene.h>
#include <voussoir/scene/space/face_forces.h>
#include <voussoir/scene/space/space_motion.h>
#include <voussoir/scene/space/space_scene.h>
#include <voussoir/statics/problem/solution.h>
#include <voussoir/terminal/terminal.h>

#include <limits>
#include <optional>
#include <vector>

namespace Voussoir
{
/** The controls of find_load_factor(). */
struct LoadFactorControls
{
  /** The greatest factor, or the least. */
  bool greatest = true;
  /** The difference of the two bounds to stop at, over the factor. */
  double tolerance = 1e-8;
  /** The number of iterations after which to give up. */
  unsigned int n_max_iterations = 300;
  /** Where is kept what is found on the way, or null. */
  Journal *journal = nullptr;
};

/**
 * The factors at which find_factor_without_dilatancy() has looked for a state,
 * each in the order of their sizes. Nothing is known of others between them.
 */
struct FactorTrials
{
  /** Factors with a state. */
  std::vector<double> with_state;
  /** Factors without one. */
  std::vector<double> without_state;
  /** True if there are none: the two bounds are proofs. */
  bool empty() const { return with_state.empty() && without_state.empty(); }
};

/**
 * The greatest factor, or the least, of the live loads that is carried beside
 * the dead loads, between two proofs; in the plane, of a Scene, or in space.
 */
template <typename SceneOf>
struct FactorOf
{
  /** True if there is no greatest, or least, factor. */
  bool is_unbounded = false;
  /** The factor of the forces, which is carried. */
  double carried = 0.;
  /** True if the dead loads alone are not carried. */
  bool collapses_without = false;
  /** None beyond it is carried; infinite if unbounded. */
  double bound = std::numeric_limits<double>::infinity();
  /** The forces at the factor `carried`. */
  typename SceneOf::Forces forces;
  /** The mechanism that proves the bound, as Mechanism::motion. */
  typename SceneOf::MotionOfBlocks mechanism;
  /** Its errors as a proof. */
  FactorBound proof;
  /** @{ */
  /** Of find_factor_without_dilatancy(). */
  Passes passes = {};
  FactorTrials trials = {};
  /**
   * What the mechanism proves for Tresca's friction with the strengths that the
   * forces at `carried` give, where they collapse without dilatancy; then
   * `mechanism` is this one, and not that of `bound`.
   */
  std::optional<FactorBound> own_collapse = {};
  /** @} */
  /** Of find_strength_factor(): true if what is carried jumps where the factor
   * is, so that nothing is proven between both bounds. */
  bool is_at_jump = false;
  /** The number of iterations. */
  unsigned int n_iterations = 0;
  /** The reason for which the method stopped. */
  Stop stop;

  /** True if there is a mechanism that proves a bound. */
  bool has_mechanism() const { return !mechanism.displacement.empty(); }
  /**
   * The factor at which the live loads are as large as the dead ones, or
   * without these as what joints bear by themselves: far below it factors are
   * zero. Zero if there is nothing to compare with.
   */
  double unit = 0.;
  /**
   * The distance of the two bounds, over the size of the larger one or a
   * thousandth of the unit, whichever is more.
   */
  double width() const;
};

/** That in the plane. */
using LoadFactor = FactorOf<Scene>;

/** One of the two. */
template <typename SceneOf>
struct FactorAnswerOf
{
  /** The factor, if any factor is carried. */
  std::optional<FactorOf<SceneOf>> factor;
  /**
   * The mechanism in which the dead loads collapse with any factor, since the
   * live ones do no work, or alone, as Mechanism::motion; of size zero if
   * neither is known.
   */
  typename SceneOf::MotionOfBlocks collapse;
  /** True if that is with any factor. */
  bool collapses_with_any = false;
};

/** That in the plane. */
using LoadFactorAnswer = FactorAnswerOf<Scene>;

/**
 * Find the greatest factor, or the least, of the loads of @p live beside those
 * of @p dead, by ProvenFactor. The dead loads need not be carried alone.
 *
 * @param dead the scene with the dead loads, in the plane or in space.
 * @param live the same scene with the live loads instead.
 * @param controls of the method.
 * @param terminal sees the iterations.
 * @throws InputError if there are no live loads.
 * @throws SolverError if no forces prove a factor.
 */
template <typename SceneOf>
FactorAnswerOf<SceneOf> find_load_factor(const SceneOf &dead,
                                         const SceneOf &live,
                                         const LoadFactorControls &controls,
                                         Terminal &terminal);
} // namespace Voussoir

#endif
