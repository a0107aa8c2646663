// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_contacts_edge_search_h
#define voussoir_packing_polyhedra_contacts_edge_search_h

#include <voussoir/packing/polyhedra/contacts/contact_search.h>
#include <voussoir/packing/polyhedra/contacts/convex_cells.h>
#include <voussoir/packing/polyhedra/contacts/edge_contact.h>

#include <vector>

namespace Voussoir
{
/** Where cells touch with edges and vertices only. */
struct EdgeContacts
{
  /** The joints, ordered by their faces. */
  std::vector<EdgeContact> joints;
  /**
   * The number of pairs of cells that touch only where parallel edges or
   * vertices meet edges or vertices: that has no normal.
   */
  unsigned int n_pairs_without_normal = 0;

  /** Add all of another list behind. */
  void append(EdgeContacts &&other);
};

/**
 * Finds the joints of cells with cells of higher numbers at edges that lie in
 * the interior of a face, at vertices that do, and at edges that cross. There
 * are none along the patches of the same two cells.
 */
class EdgeSearch
{
public:
  /** @param geometry must outlive this object. */
  explicit EdgeSearch(const FaceGeometry &geometry)
      : geometry(geometry), convex(geometry)
  {}

  /**
   * The joints of the cells from @p begin up to @p end with all cells of
   * higher numbers.
   *
   * @param patches those of these cells, as ContactSearch::patches().
   */
  EdgeContacts
  find(unsigned int begin, unsigned int end, const PatchList &patches) const;

private:
  const FaceGeometry &geometry;
  const ConvexCells convex;
};

/** What to tell the user of joints that were found; empty if none were. */
std::string notice_of(const CellFaces &cells, const EdgeContacts &contacts);
} // namespace Voussoir

#endif
