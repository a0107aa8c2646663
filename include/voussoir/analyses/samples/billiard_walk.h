// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_samples_billiard_walk_h
#define voussoir_analyses_samples_billiard_walk_h

#include <voussoir/analyses/samples/dikin_ellipsoid.h>
#include <voussoir/base/random.h>

#include <cstddef>
#include <vector>

namespace Voussoir
{
/**
 * A walk through the states of a polytope whose steps keep the uniform
 * distribution: the billiard walk of Gryazina and Polyak (*European Journal of
 * Operational Research* 238 (2014), 497). A step goes a random way, of
 * exponential length, from a state in a random direction, and is reflected
 * where it meets a limit, as a billiard ball is, in the metric of a
 * DikinEllipsoid. The way back has the same probability as the way there, so
 * that no state is preferred; nothing is adapted on the way.
 *
 * Hit-and-run (Smith, *Operations Research* 32 (1984), 1296) ends each step at
 * a random place before the limit, which in d dimensions takes some d^2 steps
 * to get from one end of the polytope to the other, even if it is round (Lovasz
 * and Vempala, *SIAM Journal on Computing* 35 (2006), 985); with reflections
 * that takes some d.
 */
class BilliardWalk
{
public:
  /**
   * @param start a state strictly inside of the limits.
   * @param seed of the random numbers.
   */
  BilliardWalk(const StatePolytope &polytope,
               const ExtremeStates &extremes,
               const DikinEllipsoid &ellipsoid,
               std::vector<double> start,
               unsigned int seed);

  /** Take @p n steps. */
  void go(unsigned int n);
  /** Where it is. */
  const std::vector<double> &state() const { return x; }

private:
  /** The limit that is met next, and after which time. */
  struct Meeting
  {
    double time;
    std::size_t limit;
  };
  void find_direction();
  template <unsigned int n_rows>
  Meeting next_limit() const;
  void reflect(const StatePolytope::Limit &limit, double size);
  void step();

  const StatePolytope &polytope;
  const std::vector<StatePolytope::Limit> &limits;
  const DikinEllipsoid &ellipsoid;
  BalancedForces balanced;
  Random random;
  /** The square of each limit's normal, outward^T C outward. */
  std::vector<double> squares;
  std::vector<double> x, direction;
};
} // namespace Voussoir

#endif
