// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_contacts_face_pieces_h
#define voussoir_packing_polyhedra_contacts_face_pieces_h

#include <voussoir/packing/polyhedra/contacts/convex_ring.h>
#include <voussoir/packing/polyhedra/contacts/face_planes.h>
#include <voussoir/packing/polyhedra/contacts/plane_frame.h>

#include <deal.II/base/array_view.h>

#include <vector>

namespace Voussoir
{
/** The convex pieces of all faces: most are one, notched ones are several. */
class FacePieces
{
public:
  /**
   * Cut what is not convex by convex_pieces(). A face that is dented by no
   * more than the tolerance counts as convex; vertices as near to the one
   * before are left out, and so are pieces as narrow.
   *
   * @param planes the planes of the faces.
   * @param tolerance a length.
   * @throws InputError if a face that is not convex crosses or touches itself.
   */
  FacePieces(const CellFaces &cells,
             const std::vector<FacePlane> &planes,
             double tolerance);

  /** The first piece of a face; the last is before that of the next face. */
  unsigned int first_of_face(const unsigned int face) const
  {
    return first_piece[face];
  }
  /** The number of pieces of all faces. */
  unsigned int size() const { return first_corner.size() - 1; }
  /** The vertex numbers of a piece, in the order of its face. */
  dealii::ArrayView<const unsigned int> corners(const unsigned int piece) const
  {
    return {loops.data() + first_corner[piece],
            first_corner[piece + 1] - first_corner[piece]};
  }
  /**
   * A piece in the coordinates of a frame, whose normal points out of the cell
   * or, if @p is_seen_from_inside, into it.
   */
  ConvexRing ring(unsigned int piece,
                  const PlaneFrame &frame,
                  bool is_seen_from_inside = false) const;

private:
  const CellFaces &cells;
  std::vector<unsigned int> first_piece = {0}, first_corner = {0}, loops;
};

/**
 * The convex pieces of a face with all of its vertices, by their numbers. A
 * face that is dented by no more than the tolerance, a length, is one piece.
 *
 * @throws InputError if a face that is not convex crosses or touches itself.
 */
std::vector<std::vector<unsigned int>> convex_pieces_of_face(
    const CellFaces &cells, unsigned int face, double tolerance);
} // namespace Voussoir

#endif
