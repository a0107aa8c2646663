// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_positions_h
#define voussoir_scene_positions_h

#include <voussoir/scene/scene.h>

#include <array>
#include <vector>

namespace Voussoir
{
/**
 * Where the cells of a packing and its supports are, as rigid bodies that moved
 * from rest.
 */
struct Positions
{
  /** At rest. */
  explicit Positions(const unsigned int n_cells)
      : displacement(n_cells), angle(n_cells, 0.)
  {}

  /** Of the centre of each cell; L. */
  std::vector<dealii::Tensor<1, 2>> displacement;
  /** Of each cell, positive counterclockwise; radians, of any size. */
  std::vector<double> angle;
  /**
   * Of each support about its midpoint at rest, in the order of
   * Motion::of_supports, with angles of any size; empty where the ground is at
   * rest.
   */
  std::vector<SupportMotion> of_supports = {};

  /** Where the point @p x of a cell at rest is; of the ground it is there. */
  dealii::Point<2> of(const Packing<2> &packing,
                      unsigned int cell,
                      const dealii::Point<2> &x) const;
  /** Where the ground under an interface has the point @p x at rest. */
  dealii::Point<2> of_ground(const Packing<2> &packing,
                             unsigned int interface,
                             const dealii::Point<2> &x) const;
  /** Cells go on by a motion times @p step, which is not small. */
  Positions advanced(const Motion &motion, double step) const;
};

/** How far apart the two cells of an interface have its points. */
struct MovedJoint
{
  /** At its start and its end along the normal midway; negative: overlap. L. */
  std::array<double, 2> openings;
  /** At its midpoint along the tangent midway; L. */
  double sliding;
};

/** The interfaces where the cells of @p packing are at @p positions. */
std::vector<MovedJoint> moved_joints(const Packing<2> &packing,
                                     const Positions &positions);

/** A packing with its cells at @p positions; see Packing<2>::moved(). */
Packing<2> moved_packing(const Packing<2> &at_rest, const Positions &positions);

/**
 * A scene where its cells are at @p positions: loads keep their directions and
 * act at the same points of the blocks, and ties go on between theirs.
 *
 * @param open_ends Scene::open_ends.
 * @param live a scene of the same packing, whose loads are added times
 *   @p factor; null for none.
 */
Scene moved_scene(const Scene &at_rest,
                  const Positions &positions,
                  std::vector<std::array<bool, 2>> open_ends,
                  const Scene *live = nullptr,
                  double factor = 0.);
} // namespace Voussoir

#endif
