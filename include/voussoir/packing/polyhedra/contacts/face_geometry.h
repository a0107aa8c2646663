// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_contacts_face_geometry_h
#define voussoir_packing_polyhedra_contacts_face_geometry_h

#include <voussoir/packing/polyhedra/contacts/cell_boxes.h>
#include <voussoir/packing/polyhedra/contacts/face_pieces.h>
#include <voussoir/packing/polyhedra/contacts/face_planes.h>

#include <algorithm>
#include <vector>

namespace Voussoir
{
/** What the search for contacts knows of faces, computed once. */
struct FaceGeometry
{
  /**
   * @param cells the cells, which must outlive this object.
   * @param distance what counts as no distance, a length; more if coordinates
   *   are rounded by more.
   * @throws InputError if a coordinate is not finite, or a face crosses itself.
   */
  FaceGeometry(const CellFaces &cells, const double distance)
      : cells(cells), planes(face_planes(cells)),
        rounding(coordinate_rounding(cells)),
        tolerance(std::max(distance, rounding)),
        pieces(cells, planes, tolerance), boxes(cells)
  {}

  /** The cells. */
  const CellFaces &cells;
  /** The planes of all faces. */
  std::vector<FacePlane> planes;
  /** The distance that rounding may move a place; a length. */
  double rounding;
  /** What counts as no distance; a length. */
  double tolerance;
  /** The convex pieces of all faces. */
  FacePieces pieces;
  /** The boxes around all cells and faces. */
  CellBoxes boxes;
};
} // namespace Voussoir

#endif
