// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_contacts_edge_contact_h
#define voussoir_packing_polyhedra_contacts_edge_contact_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace Voussoir
{
/**
 * The joint of two cells, one of which touches the other with an edge or a
 * vertex only: a polygon as good as without area, so that nothing that divides
 * by areas needs to know.
 */
struct EdgeContact
{
  /**
   * A face of either cell, that of the lower cell first: the one that is
   * touched, or one beside the edge or the vertex that touches.
   */
  std::array<unsigned int, 2> faces;
  /** The unit normal from the lower cell to the other. The polygon is too small
   * to have it to all digits. */
  dealii::Tensor<1, 3> normal;
  /** Convex, counterclockwise as seen from outside the lower cell; lengths. */
  std::vector<dealii::Point<3>> polygon;
  /** Whether it is in a point, not along an edge. */
  bool is_in_point;
};
} // namespace Voussoir

#endif
