// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_capacity_placement_h
#define voussoir_analyses_capacity_placement_h

#include <voussoir/scene/positions.h>
#include <voussoir/scene/proofs/displacement_jumps.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace Voussoir
{
/**
 * Blocks that have come apart at hinges: where they are, and which ends of
 * joints are open. The other ends touch, without overlap.
 */
class Placement
{
public:
  /**
   * At rest.
   *
   * @param at_rest has the blocks there, and outlives this.
   * @param of_supports in a step of one, about their midpoints at rest; empty
   *   where the ground does not move.
   */
  explicit Placement(const Scene &at_rest,
                     std::vector<SupportMotion> of_supports = {});

  /** Where the blocks and the supports are. */
  const Positions &positions() const { return places; }
  /** The sum of all steps; L. */
  double way() const { return gone; }
  /** The packing there. */
  Packing<2> packing() const { return moved_packing(scene->packing, places); }
  /** A scene of the same blocks there; see moved_scene(). */
  Scene moved(const Scene &at_rest,
              const Scene *live = nullptr,
              const double factor = 0.) const
  {
    return moved_scene(at_rest, places, open, live, factor);
  }

  /**
   * Open the ends that a motion from here opens.
   *
   * @param jumps of the motion.
   * @param least jump that is one; L.
   * @return a joint that slides by more, or nothing.
   */
  std::optional<unsigned int> open_ends_of(const InterfaceJumps &jumps,
                                           double least);
  /**
   * Go on along a motion, and with the supports. Ends that touch go on to do
   * so, without sliding; where open ends would overlap the step ends where the
   * first of them closes, which touches from there on.
   */
  void advance(const Motion &motion, double step);
  /**
   * Go along a motion that nothing holds back until an end that is open closes,
   * with ends that the motion opens open: a hinge goes over to another joint.
   *
   * @return false if none closes; then nothing has changed.
   */
  bool switch_hinges(const Motion &motion);

private:
  using End = std::pair<unsigned int, unsigned int>;

  std::vector<MovedJoint> joints() const
  {
    return moved_joints(scene->packing, places);
  }
  double opening_of(const End &end) const
  {
    return joints()[end.first].openings[end.second];
  }
  void go(const Placement &from, const Motion &motion, double step);
  void close_contacts();
  std::optional<End> first_overlap(const std::vector<MovedJoint> &before,
                                   double &step) const;

  const Scene *scene;
  /** The size of a block; L. */
  double size;
  std::vector<SupportMotion> of_supports;
  Positions places;
  double gone = 0.;
  /** By interface, at its start and its end. */
  std::vector<std::array<bool, 2>> open;
};
} // namespace Voussoir

#endif
