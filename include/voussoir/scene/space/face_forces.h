// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_space_face_forces_h
#define voussoir_scene_space_face_forces_h

#include <voussoir/packing/polyhedra/packing.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace Voussoir
{
/** A force on cell c- of an interface in space, at one of its FacePoints. */
struct PointForce
{
  /** Where it acts; a length. */
  dealii::Point<3> place;
  /** The force on c-; S L^2. */
  dealii::Tensor<1, 3> force;
};

/** What the forces of an interface add up to, on c-. */
struct FaceResultant
{
  /** The sum of the forces; S L^2. */
  dealii::Tensor<1, 3> force;
  /** Their moment about the centroid of the interface; S L^3. */
  dealii::Tensor<1, 3> moment;
};

/**
 * The forces of the interfaces in space, in the order of
 * Packing::interfaces(): of each those at FacePoints::pressure and behind them
 * those at FacePoints::friction, on c-. A compressive force pushes c- against
 * n_e. In the user's units.
 */
struct FaceForces
{
  /** All of them. */
  std::vector<PointForce> list;
  /** The first of each interface in the list, and at last its size. */
  std::vector<unsigned int> first = {0};

  /** True if there are none. */
  bool empty() const { return list.empty(); }
  /**
   * Those at the vertices of interface @p e, with the friction of the cells
   * that each vertex has; where blocks do not turn equal parts.
   *
   * @param n_vertices the number of its vertices.
   */
  std::vector<dealii::Tensor<1, 3>> at_vertices(unsigned int e,
                                                unsigned int n_vertices) const;
  /** What those of interface @p e add up to. */
  FaceResultant resultant(const Packing<3> &packing, unsigned int e) const;
};
} // namespace Voussoir

#endif
