// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_ranges_feasible_set_h
#define voussoir_analyses_ranges_feasible_set_h

#include <voussoir/analyses/ranges/state_program.h>
#include <voussoir/scene/proofs/face_function.h>
#include <voussoir/scene/proofs/force_function.h>
#include <voussoir/scene/space/space_motion.h>
#include <voussoir/statics/conic/feasible_state.h>

#include <cmath>
#include <mutex>
#include <optional>
#include <vector>

namespace Voussoir
{
/**
 * The greatest value that a function has among all admissible states of a
 * scene, in the plane or in space.
 */
template <typename SceneOf>
struct GreatestValueOf
{
  /** Of the forces; infinite if there is none; a force times its unit. */
  double value;
  /** What the motion proves. */
  ForceBound bound;
  /** Certificate::error() of the forces. */
  double error_of_state;
  /** A state that attains it; empty if there is none. */
  typename SceneOf::Forces forces;
  /** The motion that proves it; empty if there is none. */
  typename SceneOf::MotionOfBlocks motion;

  /** False if forces balance by themselves of which the function has more. */
  bool is_bounded() const { return std::isfinite(value); }
  /** What the bound is more than the value; zero if there is none. */
  double width() const { return is_bounded() ? bound.bound - value : 0.; }
};

/** That in the plane. */
using GreatestValue = GreatestValueOf<Scene>;

/**
 * All admissible states of a scene, which carry its loads: what a function of
 * the forces has at most among them. Every value is attained by a state, and a
 * motion proves that no state has more; see bound_of(). Both are judged by code
 * that the solvers do not share.
 */
template <typename SceneOf>
class FeasibleSetOf
{
public:
  /** @{ */
  /** Of the scene. */
  using Function = typename SceneOf::Function;
  using Greatest = GreatestValueOf<SceneOf>;
  /** @} */
  /** @param scene whose loads are carried; it must outlive this object. */
  explicit FeasibleSetOf(const SceneOf &scene);

  /**
   * The programme of the states, with one to start from. Copies of it serve
   * other threads.
   *
   * The states are_polyhedral().
   *
   * @throws SolverError if there is no state.
   */
  StateProgram program() const;
  /** False if the limits of some joints are curved. */
  bool are_polyhedral() const
  {
    const ForceRows &rows = by_rows.rows();
    return rows.sections().empty() && rows.discs().empty() &&
           rows.friction_cones().empty();
  }
  /** The number of cells. */
  unsigned int n_cells() const { return problem.n_cells(); }

  /**
   * The greatest value of @p function.
   *
   * @throws SolverError if the programme has no answer, or its proofs are none.
   */
  Greatest greatest(StateProgram &program, const Function &function) const;
  /**
   * The same, as the programme ends at first, whatever its proofs are. No other
   * balance than that of the loads is judged, if it has been loosened.
   */
  Greatest found(StateProgram &program, const Function &function) const;
  /**
   * The greatest value of @p function, by greatest_force().
   *
   * @return nothing if the interior point does not come so close that there are
   *   proofs, as where states have next to no interior.
   */
  std::optional<Greatest> greatest(const Function &function,
                                   Terminal &terminal) const;
  /** True if the proofs of @p value are good. */
  bool is_proven(const Greatest &value) const;

  /** The force that differences are relative to: the largest load on a cell. */
  double reference() const { return force; }

private:
  std::vector<double> coefficients(const Function &function) const;
  /** Those with a cost of every pressure besides. */
  std::vector<double> with_cost_of_pressure(std::vector<double> c,
                                            double cost) const;
  bool is_proven(const Greatest &value, double largest_width) const;
  Greatest judged(StateProgram::Optimum optimum,
                  const std::vector<double> &c,
                  const Function &function) const;
  bool is_ray(const std::vector<double> &x) const;
  /** A state away from the limits, if there is one; safe on all threads. */
  const std::optional<FactorState> &anchor() const;

  const SceneOf &scene;
  const DiscreteProblem problem;
  const RowProblem by_rows;
  double force;
  mutable std::once_flag anchor_is_sought;
  mutable std::optional<FactorState> of_anchor;
};

/** That in the plane. */
using FeasibleSet = FeasibleSetOf<Scene>;
} // namespace Voussoir

#endif
