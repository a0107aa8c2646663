// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_voronoi_site_faces_h
#define voussoir_packing_polyhedra_voronoi_site_faces_h

#include <deal.II/base/array_view.h>

#include <array>
#include <vector>

namespace Voussoir
{
/**
 * Faces of Voronoi cells, each between the cell of a generator and another
 * site; a face between two cells is there once.
 *
 * @tparam Corner what is known of each corner.
 */
template <typename Corner>
struct SiteFaces
{
  /**
   * The cell from which each face runs counterclockwise as seen from outside,
   * and the site behind the face.
   */
  std::vector<std::array<unsigned int, 2>> sides;
  /** The corners of one face after the other. */
  std::vector<Corner> corners;
  /** The start of each face among them, and the end: size() + 1 numbers. */
  std::vector<unsigned int> first = {0};

  /** The number of faces. */
  unsigned int size() const { return sides.size(); }
  /** The corners of a face, in order around it. */
  dealii::ArrayView<const Corner> operator[](const unsigned int face) const
  {
    return {corners.data() + first[face], first[face + 1] - first[face]};
  }
  /** End a face, whose corners were added to the list. */
  void end_face(const std::array<unsigned int, 2> &sides_of_face)
  {
    sides.push_back(sides_of_face);
    first.push_back(corners.size());
  }
  /** Give up the corners that were added since the last face. */
  void drop_face() { corners.resize(first.back()); }
};
} // namespace Voussoir

#endif
