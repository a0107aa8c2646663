// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/space_polygons.h>
#include <voussoir/stress/surface_triangles.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** The distance of one place, and the area of no triangle, over the size. */
constexpr double same_place = 1e-7, no_area = 1e-12;

/** Makes the triangles of one cell. */
class SurfaceCut
{
public:
  SurfaceCut(const std::vector<LoadedFace> &faces, const double size)
      : faces(faces), tolerance(same_place * size),
        least_area(no_area * size * size)
  {}

  SurfaceTriangles find();

private:
  /** A polygon by its points, the face that it is of, and its centroid. */
  struct Loop
  {
    unsigned int face;
    std::vector<unsigned int> points;
    Point<3> centroid;
  };

  unsigned int point_at(const Point<3> &x);
  void insert_points(Loop &loop) const;
  bool cut(const Loop &loop);
  double twice_area(const Tensor<1, 3> &normal,
                    unsigned int a,
                    unsigned int b,
                    unsigned int c) const;

  const std::vector<LoadedFace> &faces;
  const double tolerance, least_area;
  SurfaceTriangles found;
};

unsigned int SurfaceCut::point_at(const Point<3> &x)
{
  for (unsigned int k = 0; k < found.points.size(); ++k)
    if (found.points[k].distance(x) <= tolerance)
      return k;
  found.points.push_back(x);
  return found.points.size() - 1;
}

/** Insert the points that lie within the sides of a polygon. */
void SurfaceCut::insert_points(Loop &loop) const
{
  std::vector<unsigned int> with_all;
  const unsigned int n = loop.points.size();
  for (unsigned int k = 0; k < n; ++k)
  {
    const Point<3> &start = found.points[loop.points[k]];
    const Tensor<1, 3> side = found.points[loop.points[(k + 1) % n]] - start;
    const double length = side.norm();
    std::vector<std::pair<double, unsigned int>> within;
    for (unsigned int p = 0; p < found.points.size(); ++p)
    {
      const Tensor<1, 3> arm = found.points[p] - start;
      const double along = arm * side / length;
      if (along > tolerance && along < length - tolerance &&
          (arm - along / length * side).norm() <= tolerance)
        within.emplace_back(along, p);
    }
    std::sort(within.begin(), within.end());
    with_all.push_back(loop.points[k]);
    for (const auto &[along, p] : within)
      with_all.push_back(p);
  }
  loop.points = std::move(with_all);
}

double SurfaceCut::twice_area(const Tensor<1, 3> &normal,
                              const unsigned int a,
                              const unsigned int b,
                              const unsigned int c) const
{
  return cross_product_3d(found.points[b] - found.points[a],
                          found.points[c] - found.points[a]) *
         normal;
}

/** Cut into triangles between the centroid and the sides.
 *  @return false if one of them has no area. */
bool SurfaceCut::cut(const Loop &loop)
{
  const unsigned int centre = found.points.size();
  found.points.push_back(loop.centroid);
  const unsigned int n = loop.points.size();
  for (unsigned int k = 0; k < n; ++k)
  {
    const unsigned int a = loop.points[k], b = loop.points[(k + 1) % n];
    if (!(twice_area(faces[loop.face].normal, centre, a, b) > least_area))
      return false;
    found.triangles.push_back({{{centre, a, b}}, loop.face, {}, {}});
  }
  return true;
}

SurfaceTriangles SurfaceCut::find()
{
  std::vector<Loop> loops;
  for (unsigned int f = 0; f < faces.size(); ++f)
    for (const auto &polygon : faces[f].polygons)
    {
      const PolygonMoments moments = moments_of(polygon);
      Loop loop = {f, {}, moments.centroid};
      for (const Point<3> &x : polygon)
        if (const unsigned int p = point_at(x);
            loop.points.empty() ||
            (loop.points.back() != p && loop.points.front() != p))
          loop.points.push_back(p);
      if (loop.points.size() < 3)
        return found;
      // Polygons of interfaces run around n_e.
      if (moments.vector_area * faces[f].normal < 0.)
        std::reverse(loop.points.begin(), loop.points.end());
      loops.push_back(std::move(loop));
    }
  for (Loop &loop : loops)
    insert_points(loop);
  for (const Loop &loop : loops)
    if (!cut(loop))
      return found;
  number_edges(found);
  return std::move(found);
}
} // namespace

SurfaceTriangles surface_triangles(const std::vector<LoadedFace> &faces,
                                   const double size)
{
  return SurfaceCut(faces, size).find();
}

void number_edges(SurfaceTriangles &surface)
{
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> numbers;
  std::vector<double> sums;
  std::vector<unsigned int> counts;
  for (SurfaceTriangles::Triangle &triangle : surface.triangles)
    for (unsigned int m = 0; m < 3; ++m)
    {
      const unsigned int a = triangle.corners[(m + 1) % 3],
                         b = triangle.corners[(m + 2) % 3];
      const auto [place, is_new] = numbers.emplace(
          std::minmax(a, b), static_cast<unsigned int>(numbers.size()));
      if (is_new)
      {
        sums.push_back(0.);
        counts.push_back(0);
      }
      triangle.edges[m] = place->second;
      triangle.signs[m] = a < b ? 1. : -1.;
      sums[place->second] += triangle.signs[m];
      ++counts[place->second];
    }
  surface.n_edges = numbers.size();
  surface.is_closed = !surface.triangles.empty();
  for (unsigned int e = 0; e < surface.n_edges; ++e)
    surface.is_closed &= sums[e] == 0. && counts[e] == 2;
}
} // namespace Voussoir
