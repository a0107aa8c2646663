// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_ranges_range_h
#define voussoir_analyses_ranges_range_h

#include <voussoir/analyses/ranges/feasible_set.h>

#include <limits>

namespace Voussoir
{
/** How the ends of ranges are found; see FeasibleSet. */
enum class RangeMethod
{
  /** The quicker one, as far as the numbers of both tell. */
  automatic,
  /** The simplex method, each end from that of another. */
  simplex,
  /** An interior point, each end on its own. */
  interior_point
};

/** The least and the greatest value over all admissible states. */
struct Range
{
  double least = 0.;    /**< attained by a state, or minus infinity */
  double greatest = 0.; /**< attained by a state, or infinity */

  /** True if both are finite. */
  bool is_bounded() const
  {
    return least > -std::numeric_limits<double>::infinity() &&
           greatest < std::numeric_limits<double>::infinity();
  }
};

/** The errors of the proofs of many ranges. */
struct RangeProofs
{
  /** The largest distance of a value from the bound that is proven for it. */
  double width = 0.;
  /** The largest Certificate::error() of the states that attain them. */
  double error_of_states = 0.;
  /** The largest ForceBound::closing_violation. */
  double closing_violation = 0.;
  /** The number of programmes. */
  unsigned int n_programmes = 0;
  /** The number of simplex steps in them. */
  unsigned int n_iterations = 0;

  /** Add one. */
  template <typename SceneOf>
  void add(const GreatestValueOf<SceneOf> &value);
  /** Add all of them. */
  void add(const RangeProofs &others);
};
} // namespace Voussoir

#endif
