// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_ranges_space_ranges_h
#define voussoir_analyses_ranges_space_ranges_h

#include <voussoir/analyses/ranges/ranges.h>
#include <voussoir/scene/proofs/space_reactions.h>
#include <voussoir/scene/space/space_scene.h>

#include <array>
#include <vector>

namespace Voussoir
{
/** A range of each component of a vector. */
using RangeOfVector = std::array<Range, 3>;

/**
 * How much the forces of a scene in space may differ among all admissible
 * states, which all carry its loads; in the user's units, S L^2.
 */
struct SpaceRanges
{
  /** RangesWanted::interfaces. */
  std::vector<bool> wanted;
  /** The force on c- along n_e of each interface; zero if not wanted. */
  std::vector<Range> normal;
  /** The components of that across n_e; zero if not wanted. */
  std::vector<RangeOfVector> shear;
  /** @{ */
  /** The supports, and the reaction of each; empty if not wanted. */
  std::vector<PlaneSupport> supports;
  std::vector<RangeOfVector> reactions;
  /** @} */
  /** The force that differences are relative to: the largest load on a cell. */
  double reference = 0.;
  /** What proves them. */
  RangeProofs proofs;

  /** True if some force of interface @p e has no bound. */
  bool is_unbounded(unsigned int e) const;
  /** True if all states have the same force on interface @p e. */
  bool is_determined(unsigned int e) const;
};

/** find_ranges() in space. */
SpaceRanges find_ranges(const SpaceScene &scene,
                        const RangesWanted &wanted,
                        Terminal &terminal);
} // namespace Voussoir

#endif
