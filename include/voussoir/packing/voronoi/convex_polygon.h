// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_voronoi_convex_polygon_h
#define voussoir_packing_voronoi_convex_polygon_h

#include <voussoir/base/geometry.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** An axis-parallel rectangle; lengths. */
struct Rectangle
{
  dealii::Point<2> lower_left;  /**< corner; lengths */
  dealii::Point<2> upper_right; /**< corner; lengths */

  /** Width times height; L^2. */
  double area() const
  {
    return (upper_right[0] - lower_left[0]) * (upper_right[1] - lower_left[1]);
  }
};

/**
 * A convex polygon. Side i runs from vertex i to vertex i+1, counterclockwise,
 * so that the inside is to its left; lengths.
 */
class ConvexPolygon
{
public:
  /**
   * The polygon with these @p vertices, which may run clockwise and are turned.
   *
   * @throws InputError naming the vertex if they are fewer than three, not
   *   finite, without area, repeated, not convex, on the line through their
   *   neighbours, or wind more than once.
   */
  explicit ConvexPolygon(std::vector<dealii::Point<2>> vertices);

  /** The rectangle, from its lower left corner on; it has a positive area. */
  explicit ConvexPolygon(const Rectangle &rectangle);

  /** The number of sides, and of vertices. */
  unsigned int n_sides() const { return vertices.size(); }
  /** Vertex @p i, counted modulo their number. */
  const dealii::Point<2> &vertex(const unsigned int i) const
  {
    return vertices[i % n_sides()];
  }
  /** Positive; L^2. */
  double area() const { return signed_area(vertices); }

  /**
   * The signed distance of @p p from the line of a side, positive outside.
   * Exact to one rounding where the side is axis-parallel.
   */
  double beyond(const dealii::Point<2> &p, const unsigned int side) const
  {
    return normals[side] * (p - vertices[side]);
  }

  /** True if @p p is farther than @p margin inside every side. */
  bool contains(const dealii::Point<2> &p, double margin) const;

  /** "rectangle" or "polygon", for messages. */
  const std::string &shape() const { return shape_name; }
  /**
   * For messages, such as "rectangle from (0, 0) to (1, 1)" or "polygon with 6
   * vertices from (1, 0) on".
   */
  std::string description() const;

private:
  void measure();

  std::vector<dealii::Point<2>> vertices;
  /** The unit vectors out of the sides. */
  std::vector<dealii::Tensor<1, 2>> normals;
  std::string shape_name;

  /** A disk well inside, to know most points for inside at once. */
  dealii::Point<2> middle;
  double inner_radius = 0.;
};
} // namespace Voussoir

#endif
