// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_voronoi_small_features_h
#define voussoir_packing_polyhedra_voronoi_small_features_h

#include <voussoir/packing/polyhedra/voronoi/site_faces.h>
#include <voussoir/packing/polyhedra/voronoi/voronoi_sites.h>

#include <deal.II/base/point.h>

#include <vector>

namespace Voussoir
{
/** Faces by the numbers of their vertices. */
using VertexFaces = SiteFaces<unsigned int>;

/** The vertices of the faces that are looked at. */
struct FaceVertices
{
  /** The sites between which the faces are. */
  const VoronoiSites &sites;
  /** Lengths. */
  std::vector<dealii::Point<3>> places;
  /** The number of planes of the domain in which each lies. */
  std::vector<unsigned char> n_planes;
};

/**
 * The faces without what is smaller than the @p resolution, a length.
 *
 * The ends of edges that are shorter than a quarter of it become one vertex,
 * that which lies in most planes, and so do vertices next to each other along a
 * face that is narrower, or turned over, if they are no farther apart than four
 * times as much. Faces of which less than three vertices are left go, and so do
 * those that still are narrower: their vertices then are on the edges around.
 * All faces at a vertex or an edge are changed alike, so that cells that were
 * closed are closed.
 */
VertexFaces without_small_features(const VertexFaces &faces,
                                   const FaceVertices &vertices,
                                   double resolution);
} // namespace Voussoir

#endif
