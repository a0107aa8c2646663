// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_contacts_face_planes_h
#define voussoir_packing_polyhedra_contacts_face_planes_h

#include <voussoir/packing/polyhedra/cell_faces.h>

#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** The plane of a face, and what of it the face takes. */
struct FacePlane
{
  /** The unit normal out of the cell; zero if the face has no area. */
  dealii::Tensor<1, 3> normal;
  /**
   * The centroid of the face in its plane, which goes through the mean of its
   * vertices; a length.
   */
  dealii::Point<3> centre;
  /** The distance of the farthest vertex from the centre; a length. */
  double radius;
  /** The area of the projection of the face on its plane; L^2. */
  double area;
};

/**
 * The planes of all faces: normal to their vector areas.
 *
 * @throws InputError if a coordinate of a face is not finite.
 */
std::vector<FacePlane> face_planes(const CellFaces &cells);

/**
 * The distance that rounding may move a place that is computed from the
 * vertices: 16 units of rounding of the largest coordinate of a
 * face, which must be finite; a length.
 */
double coordinate_rounding(const CellFaces &cells);

/** "face 2 of cell 3", with its record if it was read; counted in its cell. */
std::string describe_face(const CellFaces &cells, unsigned int face);
} // namespace Voussoir

#endif
