// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_surface_h
#define voussoir_packing_polyhedra_models_surface_h

#include <voussoir/packing/polyhedra/models/block_mesh.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace Voussoir
{
/** The surface of a block on its way from a file to a cell. */
struct Surface
{
  /** Lengths. Some may belong to no face. */
  std::vector<dealii::Point<3>> vertices;
  /** Polygons of vertices. */
  FaceLoops faces;
  /** For each face its number in its block in the file, from zero. */
  std::vector<unsigned int> source;

  /** Add a face, of the number @p source_of_face. */
  template <typename Range>
  void add(const Range &loop, const unsigned int source_of_face)
  {
    faces.add(loop);
    source.push_back(source_of_face);
  }
};

/** A side of a face: an edge of the surface as one of its faces has it. */
struct FaceSide
{
  unsigned int low;  /**< the lower of the numbers of its two vertices */
  unsigned int high; /**< the higher of the two */
  unsigned int face; /**< the face that has it */
  bool is_forward;   /**< true if the face runs along it from low to high */

  /** True if it is the same edge. */
  bool is_along(const FaceSide &other) const
  {
    return low == other.low && high == other.high;
  }
};

/** The sides of all faces, by edges, and of each edge by faces. */
std::vector<FaceSide> sides_of(const FaceLoops &faces);

/** The end of the sides that are along the same edge as number @p k. */
std::size_t end_of_edge(const std::vector<FaceSide> &sides, std::size_t k);

/** The faces of a tetrahedron. */
constexpr unsigned int least_faces_of_polyhedron = 4;

/** True if each edge is a side of two different faces, of four at least. */
bool is_closed(const FaceLoops &faces);

/** The places of the vertices of a face. */
std::vector<dealii::Point<3>> polygon_of(const Surface &surface,
                                         unsigned int face);

/** The plane of a face, and how far its vertices are from it. */
struct SurfacePlane
{
  /** Area times the unit normal about which the face runs right-handed; L^2. */
  dealii::Tensor<1, 3> vector_area;
  /** A place in the plane; a length. */
  dealii::Point<3> place;
  /** The largest distance of a vertex from the plane; a length. */
  double deviation = 0.;
};

/**
 * The plane across the vector area of a face that is least far from its
 * vertices. Without an area there is none: the deviation is zero.
 */
SurfacePlane plane_of(const Surface &surface, unsigned int face);

/** The sums over the faces, relative to a vertex. */
struct SurfaceSums
{
  /** Negative if the faces run clockwise as seen from outside; L^3. */
  double volume = 0.;
  /** Of all faces; L^2. */
  double area = 0.;
  /** Centroid of the volume, or of no meaning without one; a length. */
  dealii::Point<3> centroid;
};

/** The sums over the faces of a surface. */
SurfaceSums sums_of(const Surface &surface);

/** The length of the diagonal of the box around the vertices; a length. */
double diagonal_of(const std::vector<dealii::Point<3>> &vertices);
} // namespace Voussoir

#endif
