// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_face_contacts_h
#define voussoir_packing_polyhedra_face_contacts_h

#include <voussoir/packing/polyhedra/cell_faces.h>
#include <voussoir/packing/polyhedra/space_polygons.h>

#include <array>
#include <vector>

namespace Voussoir
{
/** Where the faces of cells touch, and where they are free. */
struct FaceContacts
{
  /**
   * The pairs of faces that touch, that of the lower cell first, and ordered
   * by it; a pair may be there several times.
   */
  std::vector<std::array<unsigned int, 2>> faces;
  /**
   * For each pair a convex polygon in which they touch, counterclockwise as
   * seen from outside the first cell. Where there is a gap between the two
   * faces, it lies midway.
   */
  SpacePolygons patches;

  /** The faces that have free parts, ascending; one may be there often. */
  std::vector<unsigned int> free_faces;
  /** For each a convex part of it that touches no other cell. */
  SpacePolygons free_parts;
};

/** What counts as touching. */
struct ContactTolerance
{
  /**
   * The distance of faces that touch, and their lack of parallelism over the
   * size of the patch, at most; a length.
   */
  double distance;
  /** The width of a joint between two faces that face each other; a length. */
  double joint_width = 0.;
};

/**
 * Find the contacts of all cells. Faces touch where two of different cells with
 * opposite normals lie in one plane within the tolerance: in the convex
 * polygons that their convex pieces have in common. Patches and free parts
 * narrower than the tolerance are dropped. Two fixed cells touch nowhere.
 *
 * Faces that are CellFaces::shared are taken as they are.
 */
FaceContacts face_contacts(const CellFaces &cells,
                           const ContactTolerance &tolerance);
} // namespace Voussoir

#endif
