// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_loaded_faces_h
#define voussoir_stress_loaded_faces_h

#include <voussoir/scene/space/face_forces.h>
#include <voussoir/scene/space/space_scene.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace Voussoir
{
/** A part of the surface of a cell, and what goes through it; plain data. */
struct FaceLoad
{
  /** A length. */
  dealii::Point<3> centroid;
  /** Out of the cell. */
  dealii::Tensor<1, 3> normal;
  /** L^2. */
  double area;
  /** Of the area about the centroid. */
  dealii::Tensor<2, 3> second;
  /** On the cell; S L^2. */
  dealii::Tensor<1, 3> force;
  /** Of that about the centroid; S L^3. */
  dealii::Tensor<1, 3> moment;
};

/** The same with its shape. */
struct LoadedFace : FaceLoad
{
  /** What it consists of, as lists of vertices; a free face has several. */
  std::vector<dealii::ArrayView<const dealii::Point<3>>> polygons = {};
};

/**
 * The faces of all cells in space: interfaces, then free ones. What goes
 * through an edge or a vertex is on none of them, and counts as spread over the
 * block, as point loads do.
 */
std::vector<std::vector<LoadedFace>> loaded_faces(const SpaceScene &scene,
                                                  const FaceForces &forces);
} // namespace Voussoir

#endif
