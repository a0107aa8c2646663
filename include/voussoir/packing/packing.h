// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_packing_h
#define voussoir_packing_packing_h

#include <voussoir/packing/cell_loops.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <functional>
#include <string>
#include <vector>

namespace Voussoir
{
template <int dim>
class Packing;

/**
 * A packing: a mesh of polygons, its cells, with the edges between them.
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
 *
 * Vectors with an element for each cell, interface or boundary edge, here and
 * everywhere, are in the order of the cells' numbers, of interfaces() and of
 * boundary_edges(); those for each side are counted through all cells, with
 * side i of cell c at first_side(c) + i.
 */
template <>
class Packing<2>
{
public:
  /** An edge e that two cells share, or a cell and the ground. */
  struct Interface
  {
    /** c-, whose loop runs along the edge from start to end. */
    unsigned int cell_minus;
    /** c+, of the higher number; ground() if the edge is a support. */
    unsigned int cell_plus;
    dealii::Point<2> start; /**< of the edge, with c- to the left; a length */
    dealii::Point<2> end;   /**< of the edge; a length */
    /** n_e, the unit normal from c- to c+. */
    dealii::Tensor<1, 2> normal;
    /** |e|, a length. */
    double length;

    /** t_e = R(pi/2) n_e = (-n_y, n_x), the unit vector from start to end. */
    dealii::Tensor<1, 2> tangent() const;
    /** x_e, a length. */
    dealii::Point<2> midpoint() const { return start + 0.5 * (end - start); }
    /** The same, as Packing<3>::Interface::middle(). */
    dealii::Point<2> middle() const { return midpoint(); }
  };

  /** An edge of one cell only, which does not rest on the ground. */
  struct BoundaryEdge
  {
    /** The cell that has it. */
    unsigned int cell;
    dealii::Point<2> start; /**< counterclockwise around the cell; a length */
    dealii::Point<2> end;   /**< of the edge; a length */
    /** Unit normal out of the cell. */
    dealii::Tensor<1, 2> normal;
    /** |e|, a length. */
    double length;

    /** The middle between start and end, a length. */
    dealii::Point<2> midpoint() const { return start + 0.5 * (end - start); }
  };

  /**
   * Side i of a cell runs from vertex i to vertex i+1 of its loop, and is an
   * interface or a boundary edge, with this number in its list. Where cells
   * face each other across a joint the interface lies beside the side.
   */
  struct Side
  {
    /** True if it is one of boundary_edges(), and not of interfaces(). */
    bool on_boundary;
    /** Its number in that list. */
    unsigned int index;
  };

  /**
   * Check the cells and find interfaces and boundary edges, in the order of the
   * sides of cells: an interface is numbered with its c-. At first nothing
   * rests on the ground.
   *
   * @throws InputError naming the cell and the place if a cell is not a
   *   counterclockwise polygon of positive area, or is convex and its centre is
   *   outside; if its area is beyond
   *   what can be computed with, its centre is not inside, or a vertex repeats;
   *   if an edge belongs to more than two cells, or to two on the same side of
   *   it; or if a group has an impossible name.
   */
  explicit Packing(CellLoops cells);

  /**
   * Let boundary edges rest on the ground: those for which @p is_support is
   * true (one entry for each of boundary_edges()) become interfaces to it,
   * behind all others and in their order.
   */
  void support(const std::vector<bool> &is_support);

  /**
   * The packing with its cells in other places, as rigid bodies: interfaces and
   * boundary edges keep their numbers, and an interface lies midway between
   * where the two cells have its ends.
   *
   * @param place gives where a point of a cell is, at rest as a place of this
   *   packing.
   * @param place_of_ground gives where the ground under an interface is.
   */
  Packing
  moved(const std::function<dealii::Point<2>(
            unsigned int cell, const dealii::Point<2> &at_rest)> &place,
        const std::function<dealii::Point<2>(unsigned int interface,
                                             const dealii::Point<2> &at_rest)>
            &place_of_ground) const;

  /** The number F of cells, without the ground. */
  unsigned int n_cells() const { return mesh.n_cells(); }
  /** The number that stands for the ground, in Interface::cell_plus. */
  unsigned int ground() const { return n_cells(); }
  /** The number of interfaces() that are supports, the last ones. */
  unsigned int n_supports() const { return support_count; }
  /** The edges e that carry forces: those between cells, then the supports. */
  const std::vector<Interface> &interfaces() const { return interface_list; }
  /** The free boundary, on which tractions act; without the supports. */
  const std::vector<BoundaryEdge> &boundary_edges() const
  {
    return boundary_list;
  }

  /** x_c, a length: the generator of a Voronoi cell, else the centroid. */
  const dealii::Point<2> &centre(const unsigned int cell) const
  {
    return mesh.centres[cell];
  }
  /** |c|, positive; L^2. */
  double area(const unsigned int cell) const { return areas[cell]; }
  /** The sum of the areas of all cells; L^2. */
  double area() const;
  /** The box around all cells; lengths. */
  dealii::BoundingBox<2> box() const;
  /**
   * The names of the groups of cells; every cell belongs to one. The last is
   * "ground", whose only member is ground().
   */
  const std::vector<std::string> &group_names() const
  {
    return mesh.group_names;
  }
  /** The group of a cell, as its number among group_names(). */
  unsigned int group(const unsigned int cell) const
  {
    return mesh.group_of(cell, ground());
  }
  /** The name of that group. */
  const std::string &group_name(const unsigned int cell) const
  {
    return mesh.group_names[group(cell)];
  }
  /**
   * Let @p cell belong to the group @p name.
   *
   * @throws InputError if that cannot be a name; see check_group_name().
   */
  void set_group(const unsigned int cell, const std::string &name)
  {
    mesh.set_group(cell, name, n_cells());
  }

  /**
   * The distance d_e of the centres along the normal, positive; a length.
   *
   * It is (x_{c+} - x_{c-}) . n_e; to the ground the distance of x_{c-} from
   * the edge. A cell that cannot be seen whole from its centre has twice its
   * area over its perimeter for its part, the distance of the sides of a
   * regular polygon.
   */
  double distance(const Interface &interface) const;

  /** The number of sides of a cell, which is that of its vertices. */
  unsigned int n_sides(const unsigned int cell) const
  {
    return mesh.n_sides(cell);
  }
  /** The number of sides of all cells before @p cell (of all, at n_cells()). */
  unsigned int first_side(const unsigned int cell) const
  {
    return mesh.first[cell];
  }
  /** The n_sides() sides of a cell, counterclockwise. */
  dealii::ArrayView<const Side> sides(const unsigned int cell) const
  {
    return {side_list.data() + mesh.first[cell], n_sides(cell)};
  }

  /** Vertex @p i of a cell, counted modulo the number of its sides; lengths. */
  const dealii::Point<2> &vertex(const unsigned int cell,
                                 const unsigned int i) const
  {
    return mesh.vertex(cell, i);
  }

  /** The cells that are not convex; ascending numbers. */
  const std::vector<unsigned int> &not_convex() const { return concave; }
  /** The cells that cannot be seen whole from their centre; ascending. */
  const std::vector<unsigned int> &not_seen_whole() const { return hiding; }
  /** True if all of @p cell can be seen from its centre. */
  bool is_seen_whole(unsigned int cell) const;
  /** Notices to the user on how the input was understood. */
  const std::vector<std::string> &notices() const { return mesh.notices; }
  /** The narrow gaps that the input left open. */
  const std::vector<Gap> &gaps() const { return mesh.gaps; }
  /** "cell 3", with its line or feature if it was read; "the ground". */
  std::string describe(unsigned int cell) const;

private:
  void measure(unsigned int cell, bool take_centroid);
  void check_shape(unsigned int cell);
  double half_distance(unsigned int cell, const Interface &interface) const;
  /**
   * For each side, all cells' sides counted through, the side of another cell
   * along the same edge, or invalid_unsigned_int.
   */
  std::vector<unsigned int> find_opposite_sides() const;
  std::vector<unsigned int> find_shared_sides() const;
  void find_edges();
  [[noreturn]] void refuse(unsigned int cell,
                           const dealii::Point<2> &place,
                           const std::string &fault) const;

  CellLoops mesh;
  std::vector<double> areas;
  std::vector<Side> side_list;
  std::vector<Interface> interface_list;
  std::vector<BoundaryEdge> boundary_list;
  std::vector<unsigned int> concave, hiding;
  unsigned int support_count = 0;
};
} // namespace Voussoir

#endif
