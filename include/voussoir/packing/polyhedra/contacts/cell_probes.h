// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_contacts_cell_probes_h
#define voussoir_packing_polyhedra_contacts_cell_probes_h

#include <voussoir/packing/polyhedra/contacts/face_geometry.h>

#include <array>
#include <vector>

namespace Voussoir
{
/** A point of a cell that lies in another. */
struct InnerPoint
{
  /** Its distance from the surface of the other; zero if none is; a length. */
  double depth = 0.;
  /** Where it is; a length. */
  dealii::Point<3> place;
};

/** Looks for points of one cell, convex or not, in another. */
class CellProbes
{
public:
  /** @param geometry must outlive this object. */
  explicit CellProbes(const FaceGeometry &geometry) : geometry(geometry) {}

  /**
   * The deepest point in @p other of the edges of @p one, and of the lines from
   * the middle of its faces into it, that is found: their ends, and the middle
   * of their parts between faces of the other.
   */
  InnerPoint deepest(unsigned int one, unsigned int other) const;

  /** The solid angle of the surface of a cell over 4 pi: 1 inside, 0 outside.
   */
  double winding_number(unsigned int cell, const dealii::Point<3> &place) const;

  /** The distance of a place from the surface of a cell; a length. */
  double distance(unsigned int cell, const dealii::Point<3> &place) const;

private:
  using Segment = std::array<dealii::Point<3>, 2>;

  /** The first piece of the faces of a cell, and the end. */
  std::array<unsigned int, 2> pieces_of(unsigned int cell) const;
  /** The edges of a cell, and the lines into it. */
  std::vector<Segment> segments_of(unsigned int cell) const;
  /** Where a segment crosses faces of a cell, from 0 to 1, ascending. */
  std::vector<double> crossings(unsigned int cell,
                                const Segment &segment) const;
  /** The distance of a place from a piece of a face; a length. */
  double distance_from_piece(unsigned int face,
                             unsigned int piece,
                             const dealii::Point<3> &place) const;

  const FaceGeometry &geometry;
};
} // namespace Voussoir

#endif
