// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/floating_point.h>
#include <voussoir/packing/polyhedra/models/check_surface.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;
using DefectKind = ModelDefect::Kind;

namespace
{
using PlaneKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/**
 * The area of a face over the square of its length below which it has none:
 * below it the rounding of the coordinates decides on its normal.
 */
constexpr double least_relative_area = 1e-12;

/**
 * The distance of vertices from the plane of a face, over the root of its area,
 * beyond which it is a surface of another kind. In files of masonry faces are
 * off by up to a twentieth.
 */
constexpr double largest_relative_warp = 0.25;

/** True if a polygon of three or four vertices turns left everywhere. */
bool is_small_and_convex(const std::vector<Point<3>> &polygon,
                         const Tensor<1, 3> &vector_area)
{
  const std::size_t n = polygon.size();
  if (n > 4)
    return false;
  for (std::size_t i = 0; i < n; ++i)
    if (!(vector_area *
              cross_product_3d(polygon[(i + 1) % n] - polygon[i],
                               polygon[(i + 2) % n] - polygon[(i + 1) % n]) >
          0.))
      return false;
  return true;
}

/** True if a polygon crosses and touches itself nowhere, seen along an axis. */
bool is_simple_polygon(const std::vector<Point<3>> &polygon,
                       const Tensor<1, 3> &vector_area)
{
  if (is_small_and_convex(polygon, vector_area))
    return true;
  unsigned int axis = 0;
  for (unsigned int d = 1; d < 3; ++d)
    if (std::abs(vector_area[d]) > std::abs(vector_area[axis]))
      axis = d;
  std::vector<PlaneKernel::Point_2> points;
  points.reserve(polygon.size());
  for (const Point<3> &p : polygon)
    points.emplace_back(p[(axis + 1) % 3], p[(axis + 2) % 3]);
  const InvalidOperationsAllowed allowed;
  return CGAL::is_simple_2(points.begin(), points.end(), PlaneKernel());
}

/** What is wrong with a face. */
std::vector<ModelDefect> defects_of_face(const Surface &surface,
                                         const unsigned int face,
                                         double distance)
{
  if (surface.faces[face].size() < 3)
    return {}; // of a block that has few faces, and is refused for that
  const std::vector<Point<3>> polygon = polygon_of(surface, face);
  const SurfacePlane plane = plane_of(surface, face);
  const double area = plane.vector_area.norm();
  const double length = diagonal_of(polygon);
  const auto defect = [&](const DefectKind kind, const double size) {
    return std::vector<ModelDefect>{
        {kind, 0, 1, surface.source[face], size, polygon[0]}};
  };
  if (!(area > least_relative_area * length * length))
    return defect(DefectKind::flat_face, 0.);
  if (plane.deviation > largest_relative_warp * std::sqrt(area))
    return defect(DefectKind::warped_face, plane.deviation);
  if (!is_simple_polygon(polygon, plane.vector_area))
    return defect(DefectKind::crossing_face, 0.);
  if (plane.deviation > distance)
    return defect(DefectKind::bent_face, plane.deviation);
  return {};
}
/** The defects of all faces, one of each kind with its number and the worst. */
std::vector<ModelDefect> defects_of_faces(const Surface &surface,
                                          const double distance)
{
  std::vector<ModelDefect> found;
  for (unsigned int f = 0; f < surface.faces.size(); ++f)
    for (const ModelDefect &defect : defects_of_face(surface, f, distance))
    {
      const auto same =
          std::find_if(found.begin(), found.end(), [&](const ModelDefect &d) {
            return d.kind == defect.kind;
          });
      if (same == found.end())
      {
        found.push_back(defect);
        continue;
      }
      const unsigned int count = same->count + 1;
      if (defect.size > same->size)
        *same = defect;
      same->count = count;
    }
  return found;
}
} // namespace

void check_faces(MendedSurface &mended, const double distance)
{
  const std::vector<ModelDefect> found =
      defects_of_faces(mended.surface, distance);
  mended.defects.insert(mended.defects.end(), found.begin(), found.end());
}

void check_shapes_of_faces(MendedSurface &mended)
{
  // Such a face touches itself, too.
  const bool has_bridge = std::any_of(
      mended.defects.begin(), mended.defects.end(),
      [](const ModelDefect &d) { return d.kind == DefectKind::bridged_face; });
  for (const ModelDefect &defect : defects_of_faces(mended.surface, 0.))
    if (defect.kind == DefectKind::warped_face ||
        (defect.kind == DefectKind::crossing_face && !has_bridge))
      mended.defects.push_back(defect);
}
} // namespace Voussoir
