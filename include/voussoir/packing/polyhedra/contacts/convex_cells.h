// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_contacts_convex_cells_h
#define voussoir_packing_polyhedra_contacts_convex_cells_h

#include <voussoir/packing/polyhedra/contacts/face_geometry.h>

#include <deal.II/base/array_view.h>

#include <vector>

namespace Voussoir
{
/** Compares cells that are convex; faces narrower than the tolerance are none.
 */
class ConvexCells
{
public:
  /** @param geometry must outlive this object. */
  explicit ConvexCells(const FaceGeometry &geometry);

  /** True if no vertex of a cell is above one of its faces but for the
   * tolerance. */
  bool is_convex(const unsigned int cell) const { return convex[cell]; }

  /**
   * The depth of the overlap of two convex cells, the shortest displacement
   * that ends it; a length, not positive if they do not overlap. Of a depth of
   * at most @p enough, a length, only that it is no more.
   */
  double
  overlap_depth(unsigned int one, unsigned int other, double enough) const;

  /** The middle of the corners of what two convex cells have in common. */
  dealii::Point<3> common_place(unsigned int one, unsigned int other) const;

private:
  dealii::ArrayView<const unsigned int> vertices_of(unsigned int cell) const;
  bool has_width(unsigned int face) const;
  /** The least distance that @p other reaches over a face of @p one. */
  double
  least_over_faces(unsigned int one, unsigned int other, double enough) const;
  /** The same along the common normals of edges. */
  double
  least_over_edges(unsigned int one, unsigned int other, double enough) const;
  /** The distance that two cells overlap along an axis; a length. */
  double overlap_along(const dealii::Tensor<1, 3> &axis,
                       unsigned int one,
                       unsigned int other) const;
  /** The directions of the edges of a cell; lengths. */
  std::vector<dealii::Tensor<1, 3>> edges_of(unsigned int cell) const;
  /** The corners of what the faces of @p one have in common with @p other. */
  std::vector<dealii::Point<3>> corners_inside(unsigned int one,
                                               unsigned int other) const;

  const FaceGeometry &geometry;
  std::vector<unsigned int> first_vertex = {0}, vertices;
  /** Of each face the height of the cell's highest vertex above its plane. */
  std::vector<double> reach;
  std::vector<bool> convex;
};
} // namespace Voussoir

#endif
