// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/models/surface.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

std::vector<FaceSide> sides_of(const FaceLoops &faces)
{
  std::vector<FaceSide> sides;
  sides.reserve(faces.corners.size());
  for (unsigned int f = 0; f < faces.size(); ++f)
  {
    const auto loop = faces[f];
    for (unsigned int i = 0; i < loop.size(); ++i)
    {
      const unsigned int a = loop[i], b = loop[(i + 1) % loop.size()];
      sides.push_back({std::min(a, b), std::max(a, b), f, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const FaceSide &s, const FaceSide &t) {
              return std::tie(s.low, s.high, s.face) <
                     std::tie(t.low, t.high, t.face);
            });
  return sides;
}

std::size_t end_of_edge(const std::vector<FaceSide> &sides, const std::size_t k)
{
  std::size_t end = k + 1;
  while (end < sides.size() && sides[end].is_along(sides[k]))
    ++end;
  return end;
}

bool is_closed(const FaceLoops &faces)
{
  const std::vector<FaceSide> sides = sides_of(faces);
  for (std::size_t k = 0; k < sides.size(); k += 2)
    if (end_of_edge(sides, k) != k + 2 || sides[k].face == sides[k + 1].face)
      return false;
  return faces.size() >= least_faces_of_polyhedron;
}

std::vector<Point<3>> polygon_of(const Surface &surface,
                                 const unsigned int face)
{
  std::vector<Point<3>> places;
  for (const unsigned int vertex : surface.faces[face])
    places.push_back(surface.vertices[vertex]);
  return places;
}

SurfacePlane plane_of(const Surface &surface, const unsigned int face)
{
  const auto loop = surface.faces[face];
  SurfacePlane plane;
  if (loop.size() == 0)
    return plane;
  plane.place = surface.vertices[loop[0]];
  for (unsigned int i = 1; i + 1 < loop.size(); ++i)
    plane.vector_area +=
        0.5 * cross_product_3d(surface.vertices[loop[i]] - plane.place,
                               surface.vertices[loop[i + 1]] - plane.place);
  const double area = plane.vector_area.norm();
  if (!(area > 0.))
    return plane;
  const Tensor<1, 3> normal = plane.vector_area / area;
  double lowest = 0., highest = 0.; // relative to the first vertex
  for (const unsigned int vertex : loop)
  {
    const double height = normal * (surface.vertices[vertex] - plane.place);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  plane.place += 0.5 * (lowest + highest) * normal;
  plane.deviation = 0.5 * (highest - lowest);
  return plane;
}

SurfaceSums sums_of(const Surface &surface)
{
  SurfaceSums sums;
  if (surface.faces.corners.empty())
    return sums;
  const Point<3> &origin = surface.vertices[surface.faces.corners[0]];
  Tensor<1, 3> first;
  for (unsigned int f = 0; f < surface.faces.size(); ++f)
  {
    const auto loop = surface.faces[f];
    if (loop.size() == 0)
      continue;
    Tensor<1, 3> twice_area;
    const Tensor<1, 3> a = surface.vertices[loop[0]] - origin;
    for (unsigned int i = 1; i + 1 < loop.size(); ++i)
    {
      const Tensor<1, 3> b = surface.vertices[loop[i]] - origin;
      const Tensor<1, 3> c = surface.vertices[loop[i + 1]] - origin;
      const double volume = a * cross_product_3d(b, c) / 6.;
      sums.volume += volume;
      first += volume / 4. * (a + b + c);
      twice_area += cross_product_3d(b - a, c - a);
    }
    sums.area += 0.5 * twice_area.norm();
  }
  sums.centroid = origin;
  if (std::isnormal(sums.volume)) // else 1/V is none
    sums.centroid += first / sums.volume;
  return sums;
}

double diagonal_of(const std::vector<Point<3>> &vertices)
{
  if (vertices.empty())
    return 0.;
  Point<3> low = vertices[0], high = vertices[0];
  for (const Point<3> &p : vertices)
    for (unsigned int d = 0; d < 3; ++d)
    {
      low[d] = std::min(low[d], p[d]);
      high[d] = std::max(high[d], p[d]);
    }
  return low.distance(high);
}
} // namespace Voussoir
