// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_contacts_free_parts_h
#define voussoir_packing_polyhedra_contacts_free_parts_h

#include <voussoir/packing/polyhedra/contacts/contact_search.h>

#include <vector>

namespace Voussoir
{
/** Parts of faces that touch no other cell. */
struct FreeParts
{
  /** The faces that have free parts, ascending; one may be there often. */
  std::vector<unsigned int> faces;
  /** For each a convex part of it, counterclockwise as seen from outside. */
  SpacePolygons parts;

  /** Add all of another list behind. */
  void append(const FreeParts &other);
};

/**
 * The faces without their patches, cut along the sides of those into convex
 * parts. Each lies in the plane of its face, with the very vertices of that.
 */
FreeParts free_parts(const FaceGeometry &geometry, const PatchList &patches);
} // namespace Voussoir

#endif
