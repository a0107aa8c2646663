// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_contacts_cell_edges_h
#define voussoir_packing_polyhedra_contacts_cell_edges_h

#include <voussoir/packing/polyhedra/contacts/face_geometry.h>

#include <array>
#include <vector>

namespace Voussoir
{
/** An edge of a cell, the side of two of its faces. */
struct CellEdge
{
  /** The vertices from which and to which the first face runs along it. */
  std::array<unsigned int, 2> ends;
  /** The face to its left, and the one to its right, as seen from outside. */
  std::array<unsigned int, 2> faces;
  /** For each the unit vector across the edge in the face. */
  std::array<dealii::Tensor<1, 3>, 2> into_face;

  /** True if both faces leave the edge to the side of @p normal. */
  bool rises(const dealii::Tensor<1, 3> &normal) const;
  /** True if the cell has less than a half of the space around the edge. */
  bool is_convex(const FaceGeometry &geometry) const;
};

/**
 * The edges that some faces of a cell have in common and whose boxes come as
 * near to @p box as the tolerance, ordered by the lower vertex number.
 */
std::vector<CellEdge> edges_near(const FaceGeometry &geometry,
                                 const std::vector<unsigned int> &faces,
                                 const SpaceBox &box);
} // namespace Voussoir

#endif
