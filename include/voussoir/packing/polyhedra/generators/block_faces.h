// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_generators_block_faces_h
#define voussoir_packing_polyhedra_generators_block_faces_h

#include <voussoir/packing/polyhedra/generators/block_builder.h>

#include <vector>

namespace Voussoir
{
/**
 * The faces of one block, by the places of their corners: equal places are one
 * vertex. Edges between equal places are left out, and faces of which less than
 * a triangle remains.
 */
class BlockFaces
{
public:
  /** A closed loop of places; lengths. */
  using Loop = BlockBuilder::Loop;

  /**
   * The faces of a block that bends: of a polygon that goes from section to
   * section. Each of its sides makes a plane face from one section to the next;
   * a side that is level in all sections makes one horizontal face along the
   * whole block. The first and the last section are faces, too.
   *
   * @param sections two at least, plane polygons with as many vertices each,
   *   such that the faces between two of them are plane.
   */
  static BlockFaces swept(const std::vector<Loop> &sections);

  /** Add a face; all run in the same sense as seen from outside. */
  void add(const Loop &corners);

  /** Add the block that these faces bound; the faces stay here. */
  void add_to(BlockBuilder &builder, unsigned int group) const;

private:
  Loop vertices;
  std::vector<std::vector<unsigned int>> faces;
};
} // namespace Voussoir

#endif
