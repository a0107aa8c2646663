// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_cell_loops_h
#define voussoir_packing_cell_loops_h

#include <voussoir/packing/cell_records.h>

#include <deal.II/base/point.h>

#include <algorithm>
#include <array>
#include <vector>

namespace Voussoir
{
/** An open joint between two cells that nearly touch. */
struct Gap
{
  /** The two, the lower number first. */
  std::array<unsigned int, 2> cells;
  /** The widest distance of the sides that face each other; a length. */
  double width;
  /** What lies between them, counterclockwise; lengths. */
  std::array<dealii::Point<2>, 4> outline;
  /** The middle of it; a length. */
  dealii::Point<2> place() const
  {
    return 0.25 * (outline[0] + outline[1] + outline[2] + outline[3]);
  }
};

/**
 * The loops of vertices from which a Packing<2> is made. Where two cells meet
 * they share the vertices at both ends of the common edge, so a T-junction is a
 * vertex of all three cells around it, with an angle of 180 degrees in one; or
 * they face each other.
 */
struct CellLoops : CellRecords
{
  /** All vertices, in any order; lengths. */
  std::vector<dealii::Point<2>> vertices;
  /** Vertex numbers of one loop after the other, each counterclockwise. */
  std::vector<unsigned int> loops;
  /** The start of the loop of each cell, and the end: n_cells + 1 numbers. */
  std::vector<unsigned int> first = {0};
  /**
   * Pairs of sides of two cells that face each other across a joint of some
   * width and share no vertices: their numbers, counted through all cells. They
   * are one edge, whose ends lie midway between theirs.
   */
  std::vector<std::array<unsigned int, 2>> facing;
  /** The centre x_c of each cell, a length; empty to take the centroids. */
  std::vector<dealii::Point<2>> centres;

  /**
   * The distance that a vertex may lie inside the chord of its neighbours in a
   * cell that counts as convex, beyond rounding; a length. Zero for what was
   * computed, more for what was read and matched within a tolerance.
   */
  double tolerance = 0.;

  /** The narrow gaps that were left open. */
  std::vector<Gap> gaps;

  /** The number of cells. */
  unsigned int n_cells() const { return first.size() - 1; }
  /** The number of sides of a cell, which is that of its vertices. */
  unsigned int n_sides(const unsigned int cell) const
  {
    return first[cell + 1] - first[cell];
  }
  /** The cell of a side, which is counted through all cells. */
  unsigned int cell_of_side(const unsigned int side) const
  {
    return std::upper_bound(first.begin(), first.end(), side) - first.begin() -
           1;
  }
  /** Vertex @p i of a cell, counted modulo their number, by its number. */
  unsigned int corner(const unsigned int cell, const unsigned int i) const
  {
    return loops[first[cell] + i % n_sides(cell)];
  }
  /** The place of vertex @p i of a cell; lengths. */
  const dealii::Point<2> &vertex(const unsigned int cell,
                                 const unsigned int i) const
  {
    return vertices[corner(cell, i)];
  }
  /** Add a cell with the vertices @p loop, by their numbers. */
  void add(const std::vector<unsigned int> &loop)
  {
    loops.insert(loops.end(), loop.begin(), loop.end());
    first.push_back(loops.size());
  }
};
} // namespace Voussoir

#endif
