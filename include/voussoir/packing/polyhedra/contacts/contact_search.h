// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_contacts_contact_search_h
#define voussoir_packing_polyhedra_contacts_contact_search_h

#include <voussoir/packing/polyhedra/contacts/face_pair.h>
#include <voussoir/packing/polyhedra/space_polygons.h>

#include <array>
#include <vector>

namespace Voussoir
{
/** Pairs of faces that touch, and where. */
struct PatchList
{
  /** The faces of each pair, that of the lower cell first. */
  std::vector<std::array<unsigned int, 2>> faces;
  /** For each pair a convex polygon, as FaceContacts::patches. */
  SpacePolygons patches;

  /** Add all of another list behind. */
  void append(const PatchList &other);
};

/** Finds the patches of cells with cells of higher numbers. */
class ContactSearch
{
public:
  /**
   * @param geometry must outlive this object.
   * @param joint_width as ContactTolerance::joint_width.
   */
  ContactSearch(const FaceGeometry &geometry, double joint_width);

  /**
   * The patches of the cells from @p begin up to @p end with all cells of
   * higher numbers, ordered by cell, then face, then face of the other cell.
   */
  PatchList patches(unsigned int begin, unsigned int end) const;

private:
  using Pair = std::array<unsigned int, 2>;

  /** The pairs of faces of a cell that may touch, in ascending order. */
  std::vector<Pair> candidates(unsigned int cell) const;
  /** The faces of a cell that are near to a box. */
  std::vector<unsigned int> faces_near(unsigned int cell,
                                       const SpaceBox &box) const;
  /** The parts of two faces that are within the range of each other; none if
   * that is little of what they have in common: they meet along an edge. */
  ConvexRings touching_parts(const FacePair &pair) const;
  /** Add the patches of one pair of faces. */
  void add_patches(PatchList &list, const Pair &faces) const;

  const FaceGeometry &geometry;
  GapRange range;
};
} // namespace Voussoir

#endif
