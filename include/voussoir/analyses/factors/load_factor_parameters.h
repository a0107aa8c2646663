// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_factors_load_factor_parameters_h
#define voussoir_analyses_factors_load_factor_parameters_h

#include <voussoir/analyses/factors/load_factor.h>
#include <voussoir/statics/problem/solver_controls.h>

#include <deal.II/base/parameter_handler.h>

namespace Voussoir
{
/** The section `Load factor`. */
class LoadFactorParameters
{
public:
  /** What the factor multiplies. */
  enum class Factor
  {
    /** The section `Live loads`. */
    live_loads,
    /** Both sections of loads. */
    all_loads,
    /** The strengths against sliding, as a divisor. */
    strength
  };

  /** Declare the section and bind it. */
  void add_parameters(dealii::ParameterHandler &prm);

  /** What the factor multiplies. */
  Factor factor() const { return chosen; }
  /** The controls of find_load_factor(), with those of all solvers. */
  LoadFactorControls controls(const SolverControls &common) const
  {
    return {direction == Direction::greatest, common.tolerance_of_factor,
            common.n_max_iterations};
  }

private:
  enum class Direction
  {
    greatest,
    least
  };
  Factor chosen = Factor::live_loads;
  Direction direction = Direction::greatest;
};
} // namespace Voussoir

#endif
