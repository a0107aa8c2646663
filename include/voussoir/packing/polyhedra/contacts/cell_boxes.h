// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_contacts_cell_boxes_h
#define voussoir_packing_polyhedra_contacts_cell_boxes_h

#include <voussoir/packing/polyhedra/cell_faces.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <utility>
#include <vector>

namespace Voussoir
{
/** A box with sides along the axes of space. */
using SpaceBox = dealii::BoundingBox<3>;

/**
 * The least extent, of all three, of what two boxes have in common, negative
 * if they are apart: their distance along one axis; a length.
 */
double common_extent(const SpaceBox &one, const SpaceBox &other);

/** The boxes around cells and faces; finds cells by an R-tree of theirs. */
class CellBoxes
{
public:
  /** @param cells with finite coordinates. */
  explicit CellBoxes(const CellFaces &cells);
  /** The tree refers to the boxes of this object. */
  CellBoxes(const CellBoxes &) = delete;
  /** Not assigned either. */
  CellBoxes &operator=(const CellBoxes &) = delete;

  /** The box around a face. */
  const SpaceBox &of_face(const unsigned int face) const { return faces[face]; }
  /** The box around a cell; that around the origin alone if it has no face. */
  const SpaceBox &of_cell(const unsigned int cell) const { return boxes[cell]; }

  /** The cells whose boxes touch another box, in ascending order. */
  std::vector<unsigned int> touching(const SpaceBox &box) const;
  /**
   * The cells with higher numbers whose boxes come as near to that of a cell as
   * @p distance, a length, in ascending order.
   */
  std::vector<unsigned int> higher_neighbours(unsigned int cell,
                                              double distance) const;

private:
  std::vector<SpaceBox> faces, boxes;
  decltype(dealii::pack_rtree_of_indices(
      std::declval<std::vector<SpaceBox>>())) tree;
};
} // namespace Voussoir

#endif
