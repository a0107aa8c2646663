// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_space_polygons_h
#define voussoir_packing_polyhedra_space_polygons_h

#include <voussoir/packing/polyhedra/cell_faces.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace Voussoir
{
/** Plane polygons in space, the vertices of one behind those of another. */
struct SpacePolygons
{
  /** The vertices of all; lengths. */
  std::vector<dealii::Point<3>> vertices;
  /** The start of each polygon among them, and the end: size() + 1 numbers. */
  std::vector<unsigned int> first = {0};

  /** The number of polygons. */
  unsigned int size() const { return first.size() - 1; }
  /** The vertices of a polygon, in order around it. */
  dealii::ArrayView<const dealii::Point<3>>
  operator[](const unsigned int polygon) const
  {
    return {vertices.data() + first[polygon],
            first[polygon + 1] - first[polygon]};
  }
  /** Add a polygon with these @p corners, in order around it. */
  template <typename Range>
  void add(const Range &corners)
  {
    vertices.insert(vertices.end(), corners.begin(), corners.end());
    first.push_back(vertices.size());
  }
  /** Add all polygons of another list behind. */
  void append(const SpacePolygons &other)
  {
    const unsigned int offset = vertices.size();
    vertices.insert(vertices.end(), other.vertices.begin(),
                    other.vertices.end());
    for (unsigned int k = 1; k < other.first.size(); ++k)
      first.push_back(offset + other.first[k]);
  }
};

/** The area of a plane polygon, and where it is. */
struct PolygonMoments
{
  /** Area times the unit normal about which the polygon runs right-handed. */
  dealii::Tensor<1, 3> vector_area;
  /** Centroid, a length; the first vertex if there is no area. */
  dealii::Point<3> centroid;

  /** Not negative; L^2. */
  double area() const { return vector_area.norm(); }
  /** The unit vector; not a number if there is no area. */
  dealii::Tensor<1, 3> normal() const { return vector_area / area(); }
};

/**
 * The moments of a plane polygon, convex or not, by triangles from its first
 * vertex, so that a distant origin cancels nothing.
 */
PolygonMoments moments_of(dealii::ArrayView<const dealii::Point<3>> polygon);

/** The moments of a face of some cells, about its outward normal. */
PolygonMoments moments_of_face(const CellFaces &cells, unsigned int face);
} // namespace Voussoir

#endif
