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

  /**
   * Where the cells were read: the file, what its records are called, and the
   * number of the record of each cell. Empty if the cells were not read.
   */
  std::string file;
  std::string record_name = "line";
  std::vector<unsigned int> records;

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
 *
 * The ground is a cell without shape, numbered F. A boundary edge that rests on
 * it is a support: an interface from its cell to the ground.
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

  /**
   * Let boundary edges rest on the ground: those for which @p is_support is
   * true (one entry for each of boundary_edges()) become interfaces to it,
   * behind all others and in their order.
   */
  void support(const std::vector<bool> &is_support);

  unsigned int n_cells() const;
  /** The number that stands for the ground, in Interface::cell_plus. */
  unsigned int ground() const;
  /** How many of interfaces(), the last ones, are supports. */
  unsigned int n_supports() const;
  const std::vector<Interface> &interfaces() const;
  const std::vector<BoundaryEdge> &boundary_edges() const;

  const dealii::Point<2> &centre(unsigned int cell) const;
  double area(unsigned int cell) const;
  /** The sum of the areas of all cells. */
  double area() const;
  /**
   * The names of the groups of cells; every cell belongs to one. The last is
   * "ground", whose only member is ground().
   */
  const std::vector<std::string> &group_names() const;
  /** The group of a cell, as its number among group_names(). */
  unsigned int group(unsigned int cell) const;
  const std::string &group_name(unsigned int cell) const;
  /**
   * Let @p cell belong to the group @p name.
   *
   * @throws InputError if that cannot be a name; see check_group_name().
   */
  void set_group(unsigned int cell, const std::string &name);

  /** d_e = (x_{c+} - x_{c-}) . n_e; to a support the distance from x_c. */
  double distance(const Interface &interface) const;

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
   * connected group of cells that has no support.
   */
  unsigned int static_indeterminacy() const;

  /** The cells that are not convex, only star-shaped about their centre. */
  const std::vector<unsigned int> &not_convex() const;
  /** What the user ought to know of how the input was understood. */
  const std::vector<std::string> &notices() const;
  /** "cell 3", with its line or feature if it was read; "the ground". */
  std::string describe(unsigned int cell) const;

private:
  void name_groups();
  void measure(unsigned int cell, bool take_centroid);
  void check_shape(unsigned int cell);
  /**
   * For each side, all cells' sides counted through, the side of another cell
   * along the same edge, or invalid_unsigned_int.
   */
  std::vector<unsigned int> find_opposite_sides() const;
  void find_edges();
  [[noreturn]] void refuse(unsigned int cell,
                           const dealii::Point<2> &place,
                           const std::string &fault) const;

  CellLoops mesh;
  std::vector<double> areas;
  std::vector<Side> side_list;
  std::vector<Interface> interface_list;
  std::vector<BoundaryEdge> boundary_list;
  std::vector<unsigned int> star_shaped;
  unsigned int support_count = 0;
};
} // namespace Voussoir

#endif
