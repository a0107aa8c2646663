// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/convex_pieces.h>
#include <voussoir/packing/polyhedra/contacts/plane_frame.h>
#include <voussoir/packing/polyhedra/face_triangles.h>
#include <voussoir/packing/polyhedra/space_polygons.h>

#include <numeric>

namespace Voussoir
{
namespace
{
using dealii::Point;
using dealii::Tensor;

/**
 * How far a corner may turn inward by rounding alone: the double area of the
 * triangle at it over the larger square of its sides.
 */
constexpr double inward_rounding = 1e-12;

/** Add the triangles from the first corner of a convex polygon. */
void add_fan(const std::vector<unsigned int> &polygon,
             std::vector<std::array<unsigned int, 3>> &triangles)
{
  for (unsigned int i = 1; i + 1 < polygon.size(); ++i)
    triangles.push_back({{polygon[0], polygon[i], polygon[i + 1]}});
}
} // namespace

bool is_convex_face(const CellFaces &cells, const unsigned int face)
{
  const unsigned int n = cells.n_corners(face);
  if (n <= 3)
    return true;
  Tensor<1, 3> normal;
  for (unsigned int i = 1; i + 1 < n; ++i)
    normal +=
        cross_product_3d(cells.vertex(face, i) - cells.vertex(face, 0),
                         cells.vertex(face, i + 1) - cells.vertex(face, 0));
  const double size = normal.norm();
  for (unsigned int i = 0; i < n; ++i)
  {
    const Tensor<1, 3> a = cells.vertex(face, i + 1) - cells.vertex(face, i);
    const Tensor<1, 3> b =
        cells.vertex(face, i + 2) - cells.vertex(face, i + 1);
    if (cross_product_3d(a, b) * normal <
        -inward_rounding * std::max(a.norm_square(), b.norm_square()) * size)
      return false;
  }
  return true;
}

std::vector<std::array<unsigned int, 3>> triangles_of(const CellFaces &cells,
                                                      const unsigned int face)
{
  std::vector<unsigned int> all(cells.n_corners(face));
  std::iota(all.begin(), all.end(), 0);
  std::vector<std::array<unsigned int, 3>> triangles;
  const PolygonMoments moments = moments_of_face(cells, face);
  if (moments.area() > 0. && !is_convex_face(cells, face))
  {
    const PlaneFrame frame(cells.vertex(face, 0), moments.normal());
    std::vector<Point<2>> ring;
    for (const unsigned int v : cells.corners(face))
      ring.push_back(frame.project(cells.vertices[v]));
    if (is_simple(ring))
      for (const std::vector<unsigned int> &piece : convex_pieces(ring))
        add_fan(piece, triangles);
  }
  if (triangles.empty())
    add_fan(all, triangles);
  return triangles;
}
} // namespace Voussoir
