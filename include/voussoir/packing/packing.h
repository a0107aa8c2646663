// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_packing_h
#define voussoir_packing_packing_h

#include <deal.II/base/array_view.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace Voussoir
{
/**
 * The loops of vertices from which a Packing is made. Where two cells meet they
 * share the vertices at both ends of the common edge, so a T-junction is a
 * vertex of all three cells around it, with an angle of 180 degrees in one.
 */
struct CellLoops
{
  /** All vertices; a length. */
  std::vector<dealii::Point<2>> vertices;
  /** Vertex numbers of one loop after the other, each counterclockwise. */
  std::vector<unsigned int> loops;
  /** Where the loop of each cell begins, and the end: n_cells + 1 numbers. */
  std::vector<unsigned int> first = {0};
  /** The centre x_c of each cell; empty to take the centroids. */
  std::vector<dealii::Point<2>> centres;

  /**
   * The names of groups of cells, and for each cell the number of its name.
   * Both empty: every cell is called "block".
   */
  std::vector<std::string> group_names;
  std::vector<unsigned int> group;

  /**
   * How far a vertex may lie inside the chord of its neighbours in a cell that
   * counts as convex, beyond rounding; a length. Zero for what was computed,
   * more for what was read and matched within a tolerance.
   */
  double tolerance = 0.;

  /** Where the cells were read: the file and the line of each; or empty. */
  std::string file;
  std::vector<unsigned int> lines;

  /** What the user ought to know of how the input was understood. */
  std::vector<std::string> notices;
};

/**
 * A packing: a mesh of convex polygons, its cells, with the edges between them.
 * Geometry and topology only, in the user's unit of length.
 *
 * Cells c = 0..F-1 have a centre x_c. The edge shared by two cells is an
 * interface e from c- to c+, with c- < c+; its unit normal n_e points from c-
 * to c+ and its tangent is t_e = R(pi/2) n_e = (-n_y, n_x), which runs from the
 * edge's start to its end (Marazzato and Venkataramani, section 2). An edge of
 * one cell only is a boundary edge, with the outward normal.
 */
class Packing
{
public:
  struct Interface
  {
    unsigned int cell_minus;
    unsigned int cell_plus;
    dealii::Point<2> start;
    dealii::Point<2> end;
    /** Unit normal from c- to c+. */
    dealii::Tensor<1, 2> normal;
    double length;

    dealii::Tensor<1, 2> tangent() const;
    dealii::Point<2> midpoint() const;
  };

  struct BoundaryEdge
  {
    unsigned int cell;
    dealii::Point<2> start;
    dealii::Point<2> end;
    /** Unit normal out of the cell. */
    dealii::Tensor<1, 2> normal;
    double length;

    dealii::Point<2> midpoint() const;
  };

  /**
   * Side i of a cell runs from vertex i to vertex i+1 of its loop, and is an
   * interface or a boundary edge, with this number in its list.
   */
  struct Side
  {
    bool on_boundary;
    unsigned int index;
  };

  /**
   * @throws InputError naming the cell and the place if a cell is not a convex
   *   counterclockwise polygon of positive area with its centre inside, or if
   *   an edge belongs to more than two cells.
   */
  explicit Packing(CellLoops cells);

  unsigned int n_cells() const;
  const std::vector<Interface> &interfaces() const;
  const std::vector<BoundaryEdge> &boundary_edges() const;

  const dealii::Point<2> &centre(unsigned int cell) const;
  double area(unsigned int cell) const;
  /** The sum of the areas of all cells. */
  double area() const;

  /** The number of sides of a cell, which is that of its vertices. */
  unsigned int n_sides(unsigned int cell) const;
  /** The number of sides of all cells before @p cell (of all, at n_cells()). */
  unsigned int first_side(unsigned int cell) const;
  dealii::ArrayView<const Side> sides(unsigned int cell) const;
  /** Vertex @p i of a cell, counted modulo the number of its sides. */
  const dealii::Point<2> &vertex(unsigned int cell, unsigned int i) const;

  /**
   * The degree of static indeterminacy: two forces per interface, less the
   * independent equations of force balance, two per cell but for two per
   * connected group of cells.
   */
  unsigned int static_indeterminacy() const;

private:
  void measure_and_check();
  void find_edges();

  CellLoops mesh;
  std::vector<double> areas;
  std::vector<Side> side_list;
  std::vector<Interface> interface_list;
  std::vector<BoundaryEdge> boundary_list;
};

/**
 * The connected groups of cells: for each cell the lowest cell number of its
 * group. Groups touch each other nowhere, so each must be balanced by itself.
 */
std::vector<unsigned int> connected_groups(const Packing &packing);
} // namespace Voussoir

#endif
