// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_contact_face_points_h
#define voussoir_contact_face_points_h

#include <voussoir/packing/polyhedra/space_polygons.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/point.h>

#include <vector>

namespace Voussoir
{
/** A point of an interface in space at which a force acts. */
struct FacePoint
{
  /** Where; a length. */
  dealii::Point<3> place;
  /** Its part of the area, by which it has a part of what the joint has. */
  double share;
};

/** The points of one interface; the shares of each list add up to one. */
struct FacePoints
{
  /** Where it bears pressure, and friction that grows with the pressure. */
  std::vector<FacePoint> pressure;
  /** Where it bears friction that does not. */
  std::vector<FacePoint> friction;
};

/**
 * The points of an interface in space.
 *
 * Blocks that do not turn touch at its centroid. Those that do touch at its
 * vertices v_k: pressure there is pressure all over it, since any pressure has
 * the resultant of forces at the vertices, and with Coulomb's friction each of
 * its parts has. The share of v_k is that of its kite, between v_k, the middles
 * of its sides and the centroid; so sum_k w_k v_k is the centroid.
 *
 * Friction that does not depend on the pressure is the same in all cells that
 * the interface is cut into, and acts at their centroids: what these bear is
 * borne by the interface (Jensen's inequality for |.|), and with smaller cells
 * there is less that the interface bears beyond it. Cells are the kites, or
 * each of them cut into n x n.
 *
 * @param polygon convex, with its vertices in order; lengths.
 * @param blocks_turn whether moments are balanced.
 * @param n_cuts the number n.
 */
FacePoints face_points(dealii::ArrayView<const dealii::Point<3>> polygon,
                       bool blocks_turn,
                       unsigned int n_cuts = 1);

/** A vector of length one across @p normal, which has this length. */
dealii::Tensor<1, 3> tangent_of(const dealii::Tensor<1, 3> &normal);
} // namespace Voussoir

#endif
