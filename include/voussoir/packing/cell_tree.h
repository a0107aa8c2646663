// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_cell_tree_h
#define voussoir_packing_cell_tree_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/numerics/rtree.h>

#include <functional>
#include <optional>
#include <vector>

namespace Voussoir
{
/** The cell nearest to another. */
struct NearestCell
{
  /** Its number. */
  unsigned int cell;
  /** The distance between the two, zero if they touch or overlap; a length. */
  double distance;
  /** A place between them where they are that near. */
  dealii::Point<2> place;
};

/** Finds cells, by an R-tree of the boxes around them. */
class CellTree
{
public:
  /** @param rings the vertices of each cell; those that are empty are none. */
  explicit CellTree(std::vector<std::vector<dealii::Point<2>>> rings);

  /** The nearest cell to @p cell of those that @p counts; none if none does. */
  std::optional<NearestCell>
  nearest(unsigned int cell,
          const std::function<bool(unsigned int)> &counts) const;

private:
  using Box = dealii::BoundingBox<2>;
  static std::vector<Box>
  boxes_of(const std::vector<std::vector<dealii::Point<2>>> &rings);

  std::vector<std::vector<dealii::Point<2>>> rings;
  std::vector<Box> boxes;
  decltype(dealii::pack_rtree_of_indices(
      std::declval<std::vector<Box>>())) tree;
};
} // namespace Voussoir

#endif
