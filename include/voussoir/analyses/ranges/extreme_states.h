// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_ranges_extreme_states_h
#define voussoir_analyses_ranges_extreme_states_h

#include <voussoir/analyses/ranges/feasible_set.h>
#include <voussoir/analyses/ranges/state_polytope.h>

#include <vector>

namespace Voussoir
{
/**
 * Some vertices of a StatePolytope, and what they tell of it: a state in the
 * middle, the forces that are not the same in all states, and the limits that
 * some state is inside of.
 */
class ExtremeStates
{
public:
  /**
   * Find the vertices: the optima of random linear functions, of directions
   * that are all alike, and those inside of limits that all of the former are
   * at.
   *
   * @throws InputError if forces have no bound.
   * @throws SolverError as FeasibleSet does, or if friction is at its limit in
   *   all states of a joint whose forces vary.
   */
  ExtremeStates(const Scene &scene,
                const StatePolytope &polytope,
                unsigned int seed);

  /** The vertices; nondimensional. */
  const std::vector<std::vector<double>> &vertices() const { return found; }
  /** Their mean. */
  std::vector<double> middle() const;
  /** True for each force that is not the same in all states. */
  const std::vector<bool> &varies() const { return varying; }
  /** The limits that cut the polytope out: those of forces that vary. */
  const std::vector<StatePolytope::Limit> &limits() const { return cutting; }
  /**
   * The dimension of the polytope: the number of forces that vary, less that of
   * the balances that they are in. More, if some of these follow from others.
   */
  unsigned int dimension() const;

private:
  void add(const ForceFunction &function);
  void add_random(unsigned int seed);
  double largest_room(const StatePolytope::Limit &limit) const;
  void leave_limits();
  void find_varying();
  void find_limits();

  const Scene &scene;
  const StatePolytope &polytope;
  const FeasibleSet states;
  StateProgram program;
  std::vector<std::vector<double>> found;
  std::vector<bool> varying;
  std::vector<StatePolytope::Limit> cutting;
};
} // namespace Voussoir

#endif
