// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_line_work_h
#define voussoir_packing_polygons_line_work_h

#include <voussoir/packing/polygons/polygon_list.h>

#include <vector>

namespace Voussoir
{
/** A straight piece of a line that meets others at its ends only. */
struct LinePiece
{
  dealii::Point<2> start; /**< a length */
  dealii::Point<2> end;   /**< a length */
  /** The polygon of the list that it is a part of. */
  unsigned int source;
};

/**
 * The sides of all polygons and lines that are not broken, without arcs, cut
 * where vertices are no further from them than @p tolerance, a length. A vertex
 * no further from an earlier one is that. Pieces may still cross, and lie on
 * each other.
 */
std::vector<LinePiece> pieces_of_lines(const PolygonList &polygons,
                                       double tolerance);

/** What lines enclose. */
struct LineFace
{
  /** Its vertices, counterclockwise; lengths. */
  std::vector<dealii::Point<2>> ring;
  /** For each side the polygons of the list that it is a part of, ascending. */
  std::vector<std::vector<unsigned int>> sources;
  /** All of these once, ascending. */
  std::vector<unsigned int> all_sources;
  /** True if lines inside touch its boundary nowhere. */
  bool has_hole;
};

/** A piece of a line with the same face, or none, on both sides. */
struct LooseLine
{
  /** The polygon of the list that it is a part of. */
  unsigned int source;
  /** An end that no other piece has, if it has one; a length. */
  dealii::Point<2> place;
  /** Whether it has one. */
  bool ends_freely;
};

/** What pieces of lines make together. */
struct LineFaces
{
  /** In the order of the lowest of their sources. */
  std::vector<LineFace> faces;
  /** At most one for each polygon of the list, in their order. */
  std::vector<LooseLine> loose;
};

/**
 * The faces of the arrangement of line pieces, by exact arithmetic: what
 * crosses is cut there.
 */
LineFaces faces_of(const std::vector<LinePiece> &pieces);

/**
 * Make cells of the lines of a drawing that are open, in their place: the faces
 * of the arrangement of all lines and polygons that have at least one side from
 * nothing but open lines. A polygon in which such faces lie is divided, and
 * they are there for it; all others stay as they are. So what polygons alone
 * enclose between them is no cell.
 *
 * A face has the record and the group of the polygon that it is a part of, or
 * else of the line that is the longest part of its boundary.
 *
 * @param tolerance as of pieces_of_lines().
 * @throws DrawingRefused if there are faults, a line bounds no face, or a face
 *   has a hole; InputError if nothing is enclosed.
 */
void join_lines(PolygonList &polygons, double tolerance);
} // namespace Voussoir

#endif
