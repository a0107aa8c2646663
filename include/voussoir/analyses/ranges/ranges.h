// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_ranges_ranges_h
#define voussoir_analyses_ranges_ranges_h

#include <voussoir/analyses/ranges/range.h>
#include <voussoir/base/journal.h>
#include <voussoir/scene/proofs/reactions.h>
#include <voussoir/scene/scene.h>
#include <voussoir/terminal/terminal.h>

#include <algorithm>
#include <array>
#include <vector>

namespace Voussoir
{
/** The forces whose ranges are found; see find_ranges(). */
struct RangesWanted
{
  /** True for each interface whose forces are among them. */
  std::vector<bool> interfaces;
  /** True if the reactions are. */
  bool reactions = false;
  /** How. */
  RangeMethod method = RangeMethod::automatic;
  /** True if the forces of links are among them. */
  bool links = false;
  /** Where is kept what is found on the way, or null. */
  Journal *journal = nullptr;
};

/**
 * How much the forces of a scene may differ among all admissible states, which
 * all carry its loads; in the user's units, S L.
 */
struct Ranges
{
  /** RangesWanted::interfaces. */
  std::vector<bool> wanted;
  /** @{ */
  /** f_e^n and f_e^t of each interface; zero where they are not wanted. */
  std::vector<Range> normal, tangential;
  /** @} */
  /**
   * InterfaceForces::eccentricity() of each interface, over the states that
   * press it; empty where blocks do not turn, or interfaces bear tension. Not a
   * number where it is not wanted, or never pressed.
   */
  std::vector<Range> eccentricity;
  /** @{ */
  /** The straight supports, and x and y of the reaction of each; empty if not
   * wanted. */
  std::vector<StraightRun> supports;
  std::vector<std::array<Range, 2>> reactions;
  /** @} */
  /** The force of each of Scene::links; empty if not wanted. */
  std::vector<Range> links;

  /** The force that differences are relative to: the largest load on a cell. */
  double reference = 0.;
  /** What proves them. */
  RangeProofs proofs;

  /** True if those of any interface are wanted. */
  bool has_interfaces() const
  {
    return std::find(wanted.begin(), wanted.end(), true) != wanted.end();
  }

  /** The least range, over the reference, that is one. */
  static constexpr double least_range = 1e-8;
  /** True if all states have the same. */
  bool is_determined(const Range &range) const
  {
    return range.greatest - range.least <= least_range * reference;
  }
  /** True if some force of interface @p e has no bound. */
  bool is_unbounded(const unsigned int e) const
  {
    return wanted[e] && !(normal[e].is_bounded() && tangential[e].is_bounded());
  }
  /** True if all states have the same forces on interface @p e. */
  bool is_determined(const unsigned int e) const
  {
    return wanted[e] && is_determined(normal[e]) &&
           is_determined(tangential[e]);
  }
};

/**
 * Find the ranges of forces over all admissible states of a scene, by two
 * programmes each. Every value is attained by a state, and a motion proves that
 * no state goes farther; see bound_of().
 *
 * @param scene whose loads are carried.
 * @param wanted the forces.
 * @param terminal sees the progress.
 * @throws SolverError if a programme has no answer, or its proofs are none.
 */
Ranges
find_ranges(const Scene &scene, const RangesWanted &wanted, Terminal &terminal);
} // namespace Voussoir

#endif
