// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_packing_h
#define voussoir_packing_polyhedra_packing_h

#include <voussoir/base/invalid_index.h>
#include <voussoir/packing/packing.h>
#include <voussoir/packing/polyhedra/cell_faces.h>
#include <voussoir/packing/polyhedra/cell_moments.h>
#include <voussoir/packing/polyhedra/face_contacts.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <vector>

namespace Voussoir
{
/**
 * A packing in space: polyhedra, its cells, with the plane polygons in which
 * they touch. Geometry and topology only, in the user's unit of length; see
 * Packing<2>, of which this is the counterpart.
 *
 * Cells c = 0..F-1 move and have a centre x_c. An interface e is a convex plane
 * polygon in which two of them touch, from c- to c+, with c- < c+; two cells
 * may have several, and one as good as without area where they touch with an
 * edge or a vertex. Its unit normal n_e points from c- to c+, and its vertices
 * run counterclockwise as seen from c+.
 *
 * The ground has the number F. Parts of it may have a shape: the fixed cells,
 * with the numbers from F on among polyhedra(). A face, or the part of one,
 * that rests on the ground is a support: an interface from its cell to the
 * ground.
 */
template <>
class Packing<3>
{
public:
  /** A polygon e in which two cells touch, or a cell and the ground. */
  struct Interface
  {
    /** c-. */
    unsigned int cell_minus;
    /** c+, of the higher number; ground() if it is a support. */
    unsigned int cell_plus;
    /** The fixed cell of a support, if that is one. */
    unsigned int fixed_cell;
    /**
     * The faces that touch, that of c- first, as their numbers among those of
     * all polyhedra(); that of c- twice on ground without a shape.
     */
    std::array<unsigned int, 2> faces;
    /** x_e, the centroid of the polygon; a length. */
    dealii::Point<3> centroid;
    /** n_e, the unit normal from c- to c+. */
    dealii::Tensor<1, 3> normal;
    /** |e|; L^2. */
    double area;
    /** Whether an edge or a vertex touches there, see EdgeContact. */
    bool is_at_edge = false;
    /** The centroid. */
    const dealii::Point<3> &middle() const { return centroid; }
  };

  /** The part of a face that touches no other cell, and is not supported. */
  struct BoundaryFace
  {
    /** The cell that has it. */
    unsigned int cell;
    /** The face, as its number among those of all polyhedra(). */
    unsigned int face;
    /** The centroid of what is free of the face; a length. */
    dealii::Point<3> centroid;
    /** The unit normal out of the cell. */
    dealii::Tensor<1, 3> normal;
    /** The area of what is free; L^2. */
    double area;
    /** The first of its convex parts among parts(). */
    unsigned int first_part;
    /** The number of its convex parts. */
    unsigned int n_parts;
  };

  /**
   * Check the cells and find interfaces and boundary faces, in the order of the
   * cells' faces: an interface is numbered with its c-. Contacts with fixed
   * cells are supports, behind all others.
   *
   * @throws InputError naming the cell and the place if there is no cell that
   *   moves; if a cell has a vertex that is not finite, an edge that is not the
   *   side of two faces, no positive volume, or one beyond what can be computed
   *   with; or if a group has an impossible name.
   */
  explicit Packing(CellFaces cells);

  /**
   * Let boundary faces rest on the ground: those for which @p is_support is
   * true (one entry for each of boundary_faces()) become interfaces to it, one
   * for each convex part, behind all others and in their order.
   */
  void support(const std::vector<bool> &is_support);

  /** The number F of cells that move. */
  unsigned int n_cells() const { return mesh.n_cells() - mesh.n_fixed; }
  /** The number that stands for the ground, in Interface::cell_plus. */
  unsigned int ground() const { return n_cells(); }
  /** The number of interfaces() that are supports, the last ones. */
  unsigned int n_supports() const { return support_count; }
  /** The polygons e that carry forces: between cells, then the supports. */
  const std::vector<Interface> &interfaces() const { return interface_list; }
  /** The polygons of all interfaces. */
  const SpacePolygons &polygons() const { return interface_polygons; }
  /** The vertices of an interface; lengths. */
  dealii::ArrayView<const dealii::Point<3>>
  polygon(const unsigned int interface) const
  {
    return interface_polygons[interface];
  }
  /**
   * The contacts of polyhedra(), one for each of interfaces(); a pair of one
   * face twice is a contact with ground without a shape. Free parts are left
   * out.
   */
  FaceContacts contacts() const;
  /** The free boundary, on which tractions act. */
  const std::vector<BoundaryFace> &boundary_faces() const
  {
    return boundary_list;
  }
  /** The polygons of which boundary faces consist. */
  const SpacePolygons &parts() const { return part_list; }

  /** The polyhedra: cells, then fixed cells. */
  const CellFaces &polyhedra() const { return mesh; }
  /** x_c, a length: the generator of a Voronoi cell, else the centroid. */
  const dealii::Point<3> &centre(const unsigned int cell) const
  {
    return mesh.centres[cell];
  }
  /** Volume, centroid and second moments of one of polyhedra(). */
  const CellMoments &moments(const unsigned int cell) const
  {
    return moment_list[cell];
  }
  /** |c|, positive; L^3. */
  double volume(const unsigned int cell) const
  {
    return moment_list[cell].volume;
  }
  /** The sum of the volumes of the cells that move; L^3. */
  double volume() const;
  /** The area of all faces of a cell; L^2. */
  double surface(unsigned int cell) const;
  /** The box around all polyhedra; lengths. */
  dealii::BoundingBox<3> box() const { return box_of(mesh); }

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
    mesh.set_group(cell, name, mesh.n_cells());
  }

  /**
   * The distance d_e of the centres along the normal, positive; a length.
   *
   * It is (x_{c+} - x_{c-}) . n_e; to the ground the distance of x_{c-} from
   * the polygon. A cell that cannot be seen whole from its centre has three
   * times its volume over its surface for its part, the distance of the faces
   * of a regular polyhedron. Where edges or vertices touch, it is the root of
   * the area: the stress of so small a joint goes no deeper, and the joint is
   * not so soft that it decides how many digits forces have.
   */
  double distance(const Interface &interface) const;

  /** The cells that are not convex; ascending numbers. */
  const std::vector<unsigned int> &not_convex() const { return concave; }
  /** The cells that cannot be seen whole from their centre; ascending. */
  const std::vector<unsigned int> &not_seen_whole() const { return hiding; }
  /** True if all of @p cell can be seen from its centre. */
  bool is_seen_whole(unsigned int cell) const;
  /** Notices to the user on how the input was understood. */
  const std::vector<std::string> &notices() const { return notice_list; }
  /** "cell 3", with its record if it was read; "the ground". */
  std::string describe(const unsigned int cell) const
  {
    return cell == ground() ? "the ground" : mesh.describe(cell);
  }

private:
  void measure(unsigned int cell, bool take_centroid);
  void check_shape(unsigned int cell);
  void add_interfaces(const FaceContacts &contacts, bool with_ground);
  void add_interface(const std::array<unsigned int, 2> &faces,
                     dealii::ArrayView<const dealii::Point<3>> polygon,
                     const dealii::Tensor<1, 3> *normal_of_edge);
  void add_boundary(FaceContacts &contacts);
  double half_distance(unsigned int cell, const Interface &interface) const;
  [[noreturn]] void refuse(unsigned int cell,
                           const dealii::Point<3> &place,
                           const std::string &fault) const;

  CellFaces mesh;
  std::vector<CellMoments> moment_list;
  std::vector<Interface> interface_list;
  SpacePolygons interface_polygons;
  std::vector<BoundaryFace> boundary_list;
  SpacePolygons part_list;
  std::vector<unsigned int> concave, hiding;
  /** Those of the cells, and of contacts, which name cells as they are here. */
  std::vector<std::string> notice_list;
  unsigned int support_count = 0;
};
} // namespace Voussoir

#endif
