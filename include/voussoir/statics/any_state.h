// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_any_state_h
#define voussoir_statics_any_state_h

#include <voussoir/statics/extreme_rays.h>
#include <voussoir/statics/factor_bounds.h>
#include <voussoir/statics/formulation.h>

#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** The largest FactorState::residual of forces that balance the loads. */
inline constexpr double largest_residual_of_state = 1e-11;
/** The largest SelfDual::merit() of a point worth correcting to a proof. */
inline constexpr double merit_worth_correcting = 1e-2;

/** A problem with its joints by extreme rays, whose forces have bounds only. */
class RayProblem
{
public:
  /** @param problem must outlive this object. */
  explicit RayProblem(const DiscreteProblem &problem);

  /** The motion of the cells in @p u, n_dofs() numbers of any size; L. */
  Motion motion_of(std::vector<double> u) const;

  /** The problem. */
  const DiscreteProblem &problem;
  /** Its joints. */
  const ExtremeRays rays;
  /** The forces of the rays; the ground and one cell of each group are held. */
  BoundedForces forces;
};

/** What find_any_forces() found: one of the two, or neither. */
struct AnyForces
{
  /** Forces strictly within their bounds, without a factor. */
  std::optional<FactorState> state;
  /** The displacement in which the loads collapse, n_dofs() numbers. */
  std::vector<double> collapse;
  /** The number of iterations. */
  unsigned int n_iterations = 0;
};

/**
 * Find any admissible forces that balance @p loads, n_dofs() numbers without
 * those on held bodies, or their collapse, by SelfDual.
 */
AnyForces find_any_forces(RayProblem &problem,
                          const std::vector<double> &loads,
                          unsigned int n_max_iterations,
                          Terminal &terminal);

/**
 * The formulation of friction whose limit grows with the pressure, for which
 * the others select nothing: any state, far from the limits of most joints.
 */
class AnyState : public Formulation
{
public:
  std::string name() const override { return "interior point"; }
  std::string meaning() const override
  {
    return "any state, found by an interior-point method.";
  }
  std::string selection() const override
  {
    return "one of the states that carry the loads, far from the limits of "
           "most interfaces";
  }

private:
  Solution select(const DiscreteProblem &problem,
                  const SolverControls &controls,
                  Terminal &terminal) const override;
};
} // namespace Voussoir

#endif
