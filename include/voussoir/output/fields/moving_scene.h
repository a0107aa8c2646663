// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_moving_scene_h
#define voussoir_output_fields_moving_scene_h

#include <voussoir/packing/polyhedra/packing.h>
#include <voussoir/scene/loads/live_loads.h>
#include <voussoir/scene/proofs/displacement_jumps.h>
#include <voussoir/scene/scene.h>

#include <optional>
#include <type_traits>

namespace Voussoir
{
/** A scene whose cells move, as in a mechanism. */
class MovingScene
{
public:
  /**
   * All must outlive this object.
   *
   * @param live loads of which the motion bounds the factor; null if it bounds
   *   none.
   */
  MovingScene(const Scene &scene,
              const Motion &motion,
              const LiveLoads *live = nullptr)
      : scene(scene), motion(motion), live(live)
  {}

  /** The jumps of the motion, found when they are first asked for. */
  const InterfaceJumps &jumps() const
  {
    if (!found)
      found = jumps_of(scene.packing, motion);
    return *found;
  }

  const Scene &scene;          /**< what moves */
  const Motion &motion;        /**< of its cells, in any unit */
  const LiveLoads *const live; /**< or null */

private:
  mutable std::optional<InterfaceJumps> found;
};

/**
 * A part of Results or of a MovingScene that some quantities follow from: its
 * Packing, its Scene, or its Motion; or all of it.
 */
template <typename Part, typename Data>
const Part &part_of(const Data &data)
{
  if constexpr (std::is_same_v<Part, Data>)
    return data;
  else if constexpr (std::is_same_v<Part, Packing<2>>)
    return data.scene.packing;
  else if constexpr (std::is_same_v<Part, Packing<3>>)
    return data.scene.packing();
  else if constexpr (std::is_same_v<Part, Scene>)
    return data.scene;
  else
  {
    static_assert(std::is_same_v<Part, Motion>, "no part of these data");
    return data.motion;
  }
}
} // namespace Voussoir

#endif
