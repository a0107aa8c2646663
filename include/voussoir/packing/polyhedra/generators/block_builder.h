// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_generators_block_builder_h
#define voussoir_packing_polyhedra_generators_block_builder_h

#include <voussoir/packing/polyhedra/cell_faces.h>

#include <deal.II/base/point.h>

#include <array>
#include <string>
#include <vector>

namespace Voussoir
{
/**
 * The list of cells of a generator, block by block. Each block has vertices of
 * its own, so blocks need not know of their neighbours; faces that are to touch
 * are computed by the same expressions. Every block may be given in either
 * orientation, as mirror images are: its faces are turned outwards.
 */
class BlockBuilder
{
public:
  /** A closed loop of vertices; lengths. */
  using Loop = std::vector<dealii::Point<3>>;

  /** Begin without blocks; a block belongs to the group of a number. */
  explicit BlockBuilder(std::vector<std::string> group_names);

  /** Make room for a number of boxes, so that adding them copies nothing. */
  void reserve_boxes(unsigned int n_boxes);

  /** Add a box with edges along the axes, between two opposite corners. */
  void add_box(const dealii::Point<3> &low,
               const dealii::Point<3> &high,
               unsigned int group);

  /**
   * Add a prism, or the part of a pyramid or a wedge between two of its
   * sections: vertex i of @p lower is joined to vertex i of @p upper.
   *
   * @param lower three vertices at least, in a plane.
   * @param upper as many, in a plane, such that the sides are plane.
   */
  void add_frustum(const Loop &lower, const Loop &upper, unsigned int group);

  /**
   * Add a hexahedron with plane faces.
   *
   * @param corners numbered as those of deal.II's cells: the first coordinate
   *   runs fastest, the last one slowest.
   */
  void add_hexahedron(const std::array<dealii::Point<3>, 8> &corners,
                      unsigned int group);

  /**
   * Add a polyhedron, convex or not.
   *
   * @param vertices lengths.
   * @param faces vertex numbers, from 0, around each of its faces; all
   *   counterclockwise or all clockwise as seen from outside.
   */
  void add_polyhedron(const Loop &vertices,
                      const std::vector<std::vector<unsigned int>> &faces,
                      unsigned int group);

  /** The number of blocks so far. */
  unsigned int n_blocks() const { return cells.n_cells(); }

  /**
   * The blocks, in the order in which they were added; none remains here. Their
   * faces touch within a billionth of the size of them all.
   */
  CellFaces take();

private:
  /** Turn the block that was added last outwards, and note its group. */
  void finish_block(unsigned int group);

  CellFaces cells;
};
} // namespace Voussoir

#endif
