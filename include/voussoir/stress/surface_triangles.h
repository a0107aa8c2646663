// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_surface_triangles_h
#define voussoir_stress_surface_triangles_h

#include <voussoir/stress/loaded_faces.h>

#include <array>
#include <vector>

namespace Voussoir
{
/** Triangles that cover the surface of a cell and meet edge to edge. */
struct SurfaceTriangles
{
  /** One of them. */
  struct Triangle
  {
    /** Its corners among the points, counterclockwise as seen from outside. */
    std::array<unsigned int, 3> corners;
    /** The number of its face. */
    unsigned int face;
    /** The edge opposite to each corner, among all edges. */
    std::array<unsigned int, 3> edges;
    /** 1 if the triangle runs along that edge from its lower point, else -1. */
    std::array<double, 3> signs;
  };

  /** Lengths. */
  std::vector<dealii::Point<3>> points;
  /** All of them. */
  std::vector<Triangle> triangles;
  /** The number of their edges. */
  unsigned int n_edges = 0;
  /**
   * False if the faces do not close the surface edge to edge, as those of a
   * model whose joints are open, or if a triangle has no area.
   */
  bool is_closed = false;
};

/** Which corner of a polygon is cut off next. */
enum class FaceCut
{
  /** That with the shortest new side. */
  short_sides,
  /** That of which the triangle has the widest least angle. */
  wide_angles,
  /** That with the longest new side, which makes fans. */
  long_sides
};

/**
 * Cut the faces of a cell into triangles without new points: where the vertex
 * of one polygon lies within the side of another, it is a corner of both.
 *
 * @param faces of the cell.
 * @param size of it, a length, to which distances are compared.
 * @param cut of polygons with more than three corners.
 */
SurfaceTriangles surface_triangles(const std::vector<LoadedFace> &faces,
                                   double size,
                                   FaceCut cut = FaceCut::short_sides);

/**
 * Number the edges of all triangles anew, by their corners, and find whether
 * they close: each edge must be of two triangles, once each way.
 */
void number_edges(SurfaceTriangles &surface);
} // namespace Voussoir

#endif
