// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_face_contacts_h
#define voussoir_packing_polyhedra_face_contacts_h

#include <voussoir/packing/polyhedra/cell_faces.h>
#include <voussoir/packing/polyhedra/contacts/edge_contact.h>
#include <voussoir/packing/polyhedra/space_polygons.h>

#include <array>
#include <string>
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

  /**
   * Where cells touch with edges and vertices only, in the same order; such
   * joints take nothing from free parts.
   */
  std::vector<EdgeContact> at_edges;
  /** What to tell the user of them; empty if there are none. */
  std::string notice;

  /** The faces that have free parts, ascending; one may be there often. */
  std::vector<unsigned int> free_faces;
  /** For each a convex part of it that touches no other cell. */
  SpacePolygons free_parts;
};

/** What counts as touching. */
struct ContactTolerance
{
  /**
   * The distance of faces that touch, at most, everywhere in the patch; a
   * length. Where faces are at an angle, the patch is the part of what they
   * have in common that is within it, if that is at least a tenth. What is less
   * than 16 units of rounding of the largest coordinate counts as that.
   */
  double distance;
  /**
   * The width of a joint between two faces that face each other; a length. Then
   * their distance may be as much more, if nothing lies between them.
   */
  double joint_width = 0.;
  /**
   * Whether edges and vertices touch, too, if there are no joints of a width
   * between faces. An edge does that lies in the interior of a face, a
   * vertex that does, and edges that cross, where each cell is on its side
   * of the plane between them, within the distance.
   */
  bool joins_edges = false;
};

/**
 * Find the contacts of all cells. Faces touch where two of different cells with
 * opposite normals lie in one plane within the tolerance: in the convex
 * polygons that their convex pieces have in common, as far as these are within
 * the tolerance of each other. Patches and free parts
 * narrower than the tolerance are dropped, and so are faces. Corners as near to
 * a vertex or side of the other face lie on that; one that is a vertex of a
 * face in the plane of the patch is that to the last bit. Two fixed cells touch
 * nowhere.
 *
 * Patches are in the order of the lower cell, its face, and the other cell and
 * its face, whatever the number of threads.
 *
 * Faces that are CellFaces::shared are taken as they are, and all others are
 * free.
 *
 * @throws InputError if a tolerance is negative or not finite, or a coordinate
 *   is not finite, or a face that is not convex crosses itself.
 */
FaceContacts face_contacts(const CellFaces &cells,
                           const ContactTolerance &tolerance);

/** How many contacts there are. */
struct ContactCount
{
  /** The number of pairs of cells that touch. */
  unsigned int pairs_of_cells = 0;
  /** The number of patches in which they do. */
  unsigned int patches = 0;
};

/** Count contacts that were found, but for those of one face twice. */
ContactCount count_found(const CellFaces &cells, const FaceContacts &contacts);

/**
 * Count the contacts that face_contacts() would find, to see how they depend
 * on the tolerance.
 *
 * @throws InputError as face_contacts().
 */
ContactCount count_contacts(const CellFaces &cells,
                            const ContactTolerance &tolerance);
} // namespace Voussoir

#endif
