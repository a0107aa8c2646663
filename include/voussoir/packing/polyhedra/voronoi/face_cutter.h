// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_voronoi_face_cutter_h
#define voussoir_packing_polyhedra_voronoi_face_cutter_h

#include <voussoir/packing/polyhedra/voronoi/site_faces.h>
#include <voussoir/packing/polyhedra/voronoi/voronoi_sites.h>

#include <map>
#include <vector>

namespace Voussoir
{
/** A corner of a face, with the edge from there to the next corner. */
struct CutCorner
{
  /** The number of the vertex. */
  unsigned int vertex;
  /**
   * The site on the other side of the edge: it, and the two of the face, meet
   * there.
   */
  unsigned int beyond_edge;
};

/**
 * Cuts the faces of Voronoi cells at the planes of a domain, one plane after
 * the other, and closes the cells by faces in the planes.
 *
 * Faces are convex, and on which side of a plane a vertex lies is known
 * exactly, where one in the plane counts as inside: a plane therefore meets a
 * face in one segment or not at all, and the segments of a cell are a closed
 * loop, whatever the position of the generators.
 */
class FaceCutter
{
public:
  /**
   * @param sites generators, guards and planes; they must outlive this object.
   * @param places of the vertices; lengths. Those made here are added.
   */
  FaceCutter(const VoronoiSites &sites, std::vector<dealii::Point<3>> &places)
      : sites(sites), places(places), n_given(places.size())
  {}

  /**
   * What is left of @p faces inside plane @p k, and the faces in the plane. All
   * faces of the cells that reach beyond it must be given, but for those
   * that are inside as a whole.
   */
  SiteFaces<CutCorner> cut(const SiteFaces<CutCorner> &faces, unsigned int k);

  /** The number of planes in which vertex @p v lies. */
  unsigned int n_planes(const unsigned int v) const
  {
    return v < n_given ? 0 : n_planes_of_made[v - n_given];
  }

private:
  /** An edge in the plane, as the face of a cell in the plane has it. */
  struct Segment
  {
    unsigned int cell, from, to, beyond_edge;
  };

  void find_what_is_beyond(const SiteFaces<CutCorner> &faces,
                           unsigned int face,
                           unsigned int k);
  void cut_face(const SiteFaces<CutCorner> &faces,
                unsigned int face,
                unsigned int site);
  unsigned int crossing(const std::array<unsigned int, 2> &sides,
                        unsigned int beyond_edge,
                        unsigned int site);
  void add_faces_in_plane(unsigned int site);

  const VoronoiSites &sites;
  std::vector<dealii::Point<3>> &places;
  const unsigned int n_given;
  std::vector<unsigned char> n_planes_of_made;

  /** For each corner of the face that is looked at. */
  std::vector<bool> is_beyond;
  /** Of the plane that is looked at, by their names. */
  std::map<VertexName, unsigned int> crossings;
  std::vector<Segment> segments;
  SiteFaces<CutCorner> result;
};
} // namespace Voussoir

#endif
