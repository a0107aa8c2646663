// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_voronoi_convex_polyhedron_h
#define voussoir_packing_polyhedra_voronoi_convex_polyhedron_h

#include <voussoir/packing/polyhedra/cell_faces.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <vector>

namespace Voussoir
{
/** An axis-parallel box; lengths. */
struct Box
{
  dealii::Point<3> lower; /**< corner; lengths */
  dealii::Point<3> upper; /**< corner; lengths */

  /** The product of the three edges; L^3. */
  double volume() const
  {
    return (upper[0] - lower[0]) * (upper[1] - lower[1]) *
           (upper[2] - lower[2]);
  }
};

/** A convex polyhedron, by its corners and the planes of its faces. */
class ConvexPolyhedron
{
public:
  /** The plane of a face. */
  struct Plane
  {
    /** The unit vector out of the polyhedron; exact if axis-parallel. */
    dealii::Tensor<1, 3> normal;
    /** Three corners through which it goes, the first of them the origin. */
    std::array<unsigned int, 3> corners;
    /** The coordinate that is constant in it, or none. */
    unsigned int axis;
  };

  /**
   * The convex hull of @p points; faces in one plane are one, see
   * convex_hull().
   *
   * @throws InputError naming the point if one is not finite, or the points if
   *   they are fewer than four, in one plane, or too far apart or too close to
   *   each other to compute with.
   */
  explicit ConvexPolyhedron(const std::vector<dealii::Point<3>> &points);

  /**
   * The box; its volume must be positive.
   *
   * @throws InputError if it is too large or too small to compute with.
   */
  explicit ConvexPolyhedron(const Box &box);

  /** The number of faces, and of their planes. */
  unsigned int n_planes() const { return planes.size(); }
  /** The plane of face @p k. */
  const Plane &plane(const unsigned int k) const { return planes[k]; }
  /** A corner in the plane of face @p k; lengths. */
  const dealii::Point<3> &origin(const unsigned int k) const
  {
    return surface.vertices[planes[k].corners[0]];
  }
  /** The faces as one cell, whose vertices are the corners. */
  const CellFaces &faces() const { return surface; }
  /** A corner in three planes, or none if there is none. */
  unsigned int corner_in(const std::array<unsigned int, 3> &planes) const;

  /** Positive; L^3. */
  double volume() const { return volume_inside; }
  /** The centroid; lengths. */
  const dealii::Point<3> &middle() const { return centroid; }
  /** The longest edge of the axis-parallel box around it; a length. */
  double extent() const { return longest; }
  /** The largest absolute coordinate, or the extent if that is more. */
  double largest_length() const;

  /**
   * The signed distance of @p p from the plane of face @p k, positive outside;
   * a length. Exact to one rounding where the plane is axis-parallel.
   */
  double beyond(const dealii::Point<3> &p, const unsigned int k) const
  {
    return planes[k].normal * (p - origin(k));
  }

  /** True if @p p is farther than @p margin, a length, inside every plane. */
  bool contains(const dealii::Point<3> &p, double margin) const;

  /** "box" or "polyhedron", for messages. */
  const std::string &shape() const { return shape_name; }
  /**
   * For messages, such as "box from (0, 0, 0) to (1, 1, 1)" or "polyhedron with
   * 6 faces and 8 corners from (0, 0, 0) on".
   */
  std::string description() const;

private:
  void measure();
  Plane plane_of(unsigned int face) const;

  CellFaces surface;
  std::vector<Plane> planes;
  std::string shape_name;
  double volume_inside = 0.;
  double longest = 0.;

  /** The centre of a ball inside, to know most points for inside at once. */
  dealii::Point<3> centroid;
  double inner_radius = 0.;
};
} // namespace Voussoir

#endif
