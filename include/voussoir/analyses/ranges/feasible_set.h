// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_ranges_feasible_set_h
#define voussoir_analyses_ranges_feasible_set_h

#include <voussoir/analyses/ranges/state_program.h>
#include <voussoir/scene/proofs/force_function.h>
#include <voussoir/statics/conic/feasible_state.h>

#include <cmath>
#include <mutex>
#include <optional>
#include <vector>

namespace Voussoir
{
/** The greatest value that a function has among all admissible states. */
struct GreatestValue
{
  /** Of the forces; infinite if there is none; S L times its unit. */
  double value;
  /** What the motion proves. */
  ForceBound bound;
  /** Certificate::error() of the forces. */
  double error_of_state;
  /** A state that attains it; empty if there is none. */
  InterfaceForces forces;
  /** The motion that proves it; empty if there is none. */
  Motion motion;

  /** False if forces balance by themselves of which the function has more. */
  bool is_bounded() const { return std::isfinite(value); }
  /** What the bound is more than the value; zero if there is none. */
  double width() const { return is_bounded() ? bound.bound - value : 0.; }
};

/**
 * All admissible states of a scene, which carry its loads: what a function of
 * the forces has at most among them. Every value is attained by a state, and a
 * motion proves that no state has more; see bound_of(). Both are judged by code
 * that the solvers do not share.
 */
class FeasibleSet
{
public:
  /** @param scene whose loads are carried; it must outlive this object. */
  explicit FeasibleSet(const Scene &scene);

  /**
   * The programme of the states, with one to start from. Copies of it serve
   * other threads.
   *
   * The states are_polyhedral().
   *
   * @throws SolverError if there is no state.
   */
  StateProgram program() const;
  /** False if some joints are sections, whose limits are curved. */
  bool are_polyhedral() const { return by_rows.rows().sections().empty(); }

  /**
   * The greatest value of @p function.
   *
   * @throws SolverError if the programme has no answer, or its proofs are none.
   */
  GreatestValue greatest(StateProgram &program,
                         const ForceFunction &function) const;
  /**
   * The same, as the programme ends at first, whatever its proofs are. No other
   * balance than that of the loads is judged, if it has been loosened.
   */
  GreatestValue found(StateProgram &program,
                      const ForceFunction &function) const;
  /**
   * The greatest value of @p function, by greatest_force().
   *
   * @return nothing if the interior point does not come so close that there are
   *   proofs, as where states have next to no interior.
   */
  std::optional<GreatestValue> greatest(const ForceFunction &function,
                                        Terminal &terminal) const;
  /** True if the proofs of @p value are good. */
  bool is_proven(const GreatestValue &value) const;

  /** The force that differences are relative to: the largest load on a cell. */
  double reference() const { return force; }

private:
  std::vector<double> coefficients(const ForceFunction &function) const;
  bool is_proven(const GreatestValue &value, double largest_width) const;
  GreatestValue judged(StateProgram::Optimum optimum,
                       const std::vector<double> &c,
                       const ForceFunction &function) const;
  bool is_ray(const std::vector<double> &x) const;
  /** A state away from the limits, if there is one; safe on all threads. */
  const std::optional<FactorState> &anchor() const;

  const Scene &scene;
  const DiscreteProblem problem;
  const RowProblem by_rows;
  double force;
  mutable std::once_flag anchor_is_sought;
  mutable std::optional<FactorState> of_anchor;
};
} // namespace Voussoir

#endif
