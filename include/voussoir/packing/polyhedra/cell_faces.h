// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_cell_faces_h
#define voussoir_packing_polyhedra_cell_faces_h

#include <voussoir/packing/cell_records.h>
#include <voussoir/packing/polyhedra/cell_defects.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/point.h>

#include <algorithm>
#include <array>
#include <vector>

namespace Voussoir
{
/**
 * The polyhedra from which a Packing<3> is made, as flat lists. A face is a
 * plane polygon without holes, convex or not, whose vertices run
 * counterclockwise as seen from outside its cell; faces are numbered through
 * all cells. No two neighbouring faces of a cell lie in one plane.
 *
 * Behind the cells that move there may be cells that do not: they are a part of
 * the ground that has a shape.
 */
struct CellFaces : CellRecords
{
  /** All vertices, in any order; lengths. */
  std::vector<dealii::Point<3>> vertices;
  /** Vertex numbers of one face after the other. */
  std::vector<unsigned int> loops;
  /** The start of the loop of each face, and the end: n_faces() + 1 numbers. */
  std::vector<unsigned int> first_corner = {0};
  /** The first face of each cell, and the end: n_cells() + 1 numbers. */
  std::vector<unsigned int> first_face = {0};
  /** The number of cells at the end that do not move. */
  unsigned int n_fixed = 0;

  /** x_c of each cell, a length; empty to take the centroids of volume. */
  std::vector<dealii::Point<3>> centres;

  /**
   * Pairs of faces of two cells that are the same polygon, with the same
   * vertex numbers in opposite order. If there are any, faces touch nowhere
   * else; if there are none, they are matched by their places.
   */
  std::vector<std::array<unsigned int, 2>> shared;

  /** What was wrong with the cells as a file has them. */
  std::vector<CellDefect> defects;

  /** The distance between faces that touch, at most; a length. */
  double tolerance = 0.;
  /** The width of joints between faces that face each other; a length. */
  double joint_width = 0.;
  /** Whether edges and vertices get joints, too; for blocks that turn. */
  bool joins_edges = false;

  /** The number of cells, fixed ones included. */
  unsigned int n_cells() const { return first_face.size() - 1; }
  /** The number of faces of all cells. */
  unsigned int n_faces() const { return first_corner.size() - 1; }
  /** The number of vertices of a face. */
  unsigned int n_corners(const unsigned int face) const
  {
    return first_corner[face + 1] - first_corner[face];
  }
  /** The vertex numbers of a face. */
  dealii::ArrayView<const unsigned int> corners(const unsigned int face) const
  {
    return {loops.data() + first_corner[face], n_corners(face)};
  }
  /** Vertex @p i of a face, counted modulo their number; lengths. */
  const dealii::Point<3> &vertex(const unsigned int face,
                                 const unsigned int i) const
  {
    return vertices[loops[first_corner[face] + i % n_corners(face)]];
  }
  /** The places of the vertices of a face. */
  std::vector<dealii::Point<3>> polygon(const unsigned int face) const
  {
    std::vector<dealii::Point<3>> places;
    for (const unsigned int v : corners(face))
      places.push_back(vertices[v]);
    return places;
  }
  /** The cell that has a face. */
  unsigned int cell_of_face(const unsigned int face) const
  {
    return std::upper_bound(first_face.begin(), first_face.end(), face) -
           first_face.begin() - 1;
  }
  /** Add a face to the cell that comes next, by its vertices' numbers. */
  template <typename Range>
  void add_face(const Range &corners)
  {
    loops.insert(loops.end(), corners.begin(), corners.end());
    first_corner.push_back(loops.size());
  }
  /** End a cell, which has the faces that were added since the last. */
  void end_cell() { first_face.push_back(n_faces()); }
};
} // namespace Voussoir

#endif
