// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_voronoi_narrow_faces_h
#define voussoir_packing_polyhedra_voronoi_narrow_faces_h

#include <voussoir/packing/polyhedra/voronoi/site_faces.h>
#include <voussoir/packing/polyhedra/voronoi/voronoi_sites.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace Voussoir
{
/** A face, as seen along its chord: from one end to the other. */
class NarrowLoop
{
public:
  /**
   * @param corners vertex numbers around the face, three or more; they must
   *   outlive this object.
   * @param places of all vertices; lengths. They must outlive this object.
   */
  NarrowLoop(dealii::ArrayView<const unsigned int> corners,
             const std::vector<dealii::Point<3>> &places);

  /**
   * True if the area is at most that of the chord times the @p width, a length.
   *
   * @param normal the unit vector about which the face should run right-handed:
   *   if it runs the other way, its area is negative.
   */
  bool is_narrower_than(double width, const dealii::Tensor<1, 3> &normal) const;

  /** The different vertices in the order of their places along the chord. */
  std::vector<unsigned int> along_chord() const;

private:
  dealii::ArrayView<const unsigned int> corners;
  const std::vector<dealii::Point<3>> &places;
  /** The beginning of the chord; lengths. */
  dealii::Point<3> origin;
  /** From there to its end; lengths. */
  dealii::Tensor<1, 3> chord;
};

/**
 * Add a face to @p faces, cut at the vertices to which its @p loop comes back.
 * Parts with fewer than three vertices enclose no area and are left out.
 */
void add_simple_loops(SiteFaces<unsigned int> &faces,
                      const std::array<unsigned int, 2> &sides,
                      const std::vector<unsigned int> &loop);

/**
 * The faces without those narrower than the @p resolution, a length. The
 * vertices of a face that goes are put on its edges in the order along its
 * chord, in all faces at these edges, so that cells that were closed are
 * closed.
 *
 * @param faces their loops visit a vertex once.
 * @param places of the vertices; lengths.
 * @param sites between which the faces are.
 */
SiteFaces<unsigned int>
without_narrow_faces(SiteFaces<unsigned int> faces,
                     const std::vector<dealii::Point<3>> &places,
                     const VoronoiSites &sites,
                     double resolution);
} // namespace Voussoir

#endif
