// SPDX-License-Identifier: LGPL-2.1-or-later
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
  SurfaceCut(const std::vector<LoadedFace> &faces,
             const double size,
             const FaceCut rule)
      : faces(faces), tolerance(same_place * size),
        least_area(no_area * size * size), rule(rule)
  {}

  SurfaceTriangles find();

private:
  /** A polygon by its points, and the face that it is of. */
  struct Loop
  {
    unsigned int face;
    std::vector<unsigned int> points;
  };

  unsigned int point_at(const Point<3> &x);
  void insert_points(Loop &loop) const;
  bool cut(Loop loop);
  double merit(unsigned int a, unsigned int b, unsigned int c) const;
  double twice_area(const Tensor<1, 3> &normal,
                    unsigned int a,
                    unsigned int b,
                    unsigned int c) const;

  const std::vector<LoadedFace> &faces;
  const double tolerance, least_area;
  const FaceCut rule;
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

/** How good it is to cut off corner b between a and c. */
double SurfaceCut::merit(const unsigned int a,
                         const unsigned int b,
                         const unsigned int c) const
{
  const auto &x = found.points;
  const double side = x[a].distance(x[c]);
  if (rule == FaceCut::short_sides)
    return -side;
  if (rule == FaceCut::long_sides)
    return side;
  std::array<double, 3> sides = {
      {x[a].distance(x[b]), x[b].distance(x[c]), side}};
  std::sort(sides.begin(), sides.end());
  return cross_product_3d(x[b] - x[a], x[c] - x[a]).norm() /
         (sides[1] * sides[2]);
}

/** Cut off one corner after the other, of all those whose triangle has an area
 * the best. */
bool SurfaceCut::cut(Loop loop)
{
  const Tensor<1, 3> &normal = faces[loop.face].normal;
  std::vector<unsigned int> &p = loop.points;
  while (p.size() >= 3)
  {
    const unsigned int n = p.size();
    unsigned int best = n;
    double greatest = 0.;
    for (unsigned int k = 0; k < n; ++k)
    {
      const unsigned int before = p[(k + n - 1) % n], after = p[(k + 1) % n];
      if (!(twice_area(normal, before, p[k], after) > least_area))
        continue;
      // What is left must not be a line.
      double left = 0.;
      for (unsigned int m = 1; m + 2 < n; ++m)
        left +=
            twice_area(normal, after, p[(k + 1 + m) % n], p[(k + 2 + m) % n]);
      if (n > 3 && !(left > least_area))
        continue;
      const double of_this = merit(before, p[k], after);
      if (best < n && of_this <= greatest)
        continue;
      best = k;
      greatest = of_this;
    }
    if (best == n)
      return false;
    found.triangles.push_back(
        {{{p[(best + n - 1) % n], p[best], p[(best + 1) % n]}},
         loop.face,
         {},
         {}});
    p.erase(p.begin() + best);
    if (n == 3)
      return true;
  }
  return false;
}

SurfaceTriangles SurfaceCut::find()
{
  std::vector<Loop> loops;
  for (unsigned int f = 0; f < faces.size(); ++f)
    for (const auto &polygon : faces[f].polygons)
    {
      Loop loop = {f, {}};
      for (const Point<3> &x : polygon)
        if (const unsigned int p = point_at(x);
            loop.points.empty() ||
            (loop.points.back() != p && loop.points.front() != p))
          loop.points.push_back(p);
      if (loop.points.size() < 3)
        return found;
      double area = 0.;
      for (unsigned int k = 1; k + 1 < loop.points.size(); ++k)
        area += twice_area(faces[f].normal, loop.points[0], loop.points[k],
                           loop.points[k + 1]);
      // Polygons of interfaces run around n_e.
      if (area < 0.)
        std::reverse(loop.points.begin(), loop.points.end());
      loops.push_back(std::move(loop));
    }
  for (Loop &loop : loops)
  {
    insert_points(loop);
    if (!cut(loop))
      return found;
  }
  number_edges(found);
  return std::move(found);
}
} // namespace

SurfaceTriangles surface_triangles(const std::vector<LoadedFace> &faces,
                                   const double size,
                                   const FaceCut cut)
{
  return SurfaceCut(faces, size, cut).find();
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
