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

/**
 * Cut the faces of a cell into the triangles between the sides of their
 * polygons and the centroids of these; where the vertex of one polygon lies
 * within the side of another, it is a corner of both. So triangles do not
 * depend on where a face begins, nor on how the cell is turned.
 *
 * @param faces of the cell, whose polygons are convex.
 * @param size of it, a length, to which distances are compared.
 */
SurfaceTriangles surface_triangles(const std::vector<LoadedFace> &faces,
                                   double size);

/**
 * Number the edges of all triangles anew, by their corners, and find whether
 * they close: each edge must be of two triangles, once each way.
 */
void number_edges(SurfaceTriangles &surface);
} // namespace Voussoir

#endif
