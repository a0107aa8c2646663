// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_voronoi_cell_cutter_h
#define voussoir_packing_voronoi_cell_cutter_h

#include <voussoir/base/invalid_index.h>
#include <voussoir/packing/voronoi/convex_polygon.h>

#include <array>
#include <map>
#include <vector>

namespace Voussoir
{
/**
 * Cuts the Voronoi cells of points in a convex polygon at its sides, so that
 * they fit each other to the last bit.
 *
 * Vertices are identified by name. An edge of a cell lies between two
 * generators or on a side of the polygon, so a new vertex is either the point
 * of a side that is equidistant from two generators, or a corner of the
 * polygon. Its position is computed from these alone, in the same way for all
 * cells around it, and lies on the side to one rounding whatever the shape of
 * the cells. As the sides are taken one after the other, two neighbours cut
 * their common edge by the same decisions, rounding or not.
 */
class CellCutter
{
public:
  /** A vertex of a cell, with the edge from there to the next vertex. */
  struct Corner
  {
    /** Its coordinates; lengths. */
    dealii::Point<2> position;
    /** The number of the vertex; none for one that is cut off later. */
    unsigned int vertex = invalid_index;
    /** The cell on the other side of the edge, or none. */
    unsigned int neighbour = invalid_index;
    /** The side of the polygon on which the edge lies, or none. */
    unsigned int side = invalid_index;
  };

  /** A vertex made by cutting. */
  struct Vertex
  {
    /** Its coordinates; lengths. */
    dealii::Point<2> position;
    /** Sides of the polygon on which it lies: one, or two in a corner. */
    unsigned int n_sides;
  };

  /**
   * @param polygon that cuts the cells; it must outlive this object.
   * @param generators of the cells, in the order of these; they must outlive
   *   this object.
   * @param first_vertex the number of the first vertex that is made here.
   */
  CellCutter(const ConvexPolygon &polygon,
             const std::vector<dealii::Point<2>> &generators,
             const unsigned int first_vertex)
      : polygon(polygon), generators(generators), first_vertex(first_vertex),
        corners(polygon.n_sides(), invalid_index)
  {}

  /**
   * Cut the counterclockwise @p loop of a cell down to what is inside.
   *
   * @param cell its number, which is that of its generator.
   * @param loop has the neighbours set; vertices that are made get numbers, and
   *   edges that come to lie on the polygon their side.
   */
  void cut(unsigned int cell, std::vector<Corner> &loop);

  /** All vertices made so far, in the order of their numbers. */
  const std::vector<Vertex> &made_vertices() const { return vertices; }

private:
  void cut_at_side(unsigned int cell, unsigned int side);
  Corner meeting_point(unsigned int cell,
                       const Corner &start,
                       const Corner &end,
                       unsigned int side);
  unsigned int crossing(unsigned int a, unsigned int b, unsigned int side);
  unsigned int polygon_corner(unsigned int i);

  const ConvexPolygon &polygon;
  const std::vector<dealii::Point<2>> &generators;
  const unsigned int first_vertex;

  std::vector<Vertex> vertices;
  /** By the two generators, the lower first, and the side. */
  std::map<std::array<unsigned int, 3>, unsigned int> crossings;
  std::vector<unsigned int> corners;
  std::vector<Corner> remaining, result;
};
} // namespace Voussoir

#endif
