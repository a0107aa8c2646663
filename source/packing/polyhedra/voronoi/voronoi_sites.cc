// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/invalid_index.h>
#include <voussoir/packing/cgal_result.h>
#include <voussoir/packing/polyhedra/voronoi/voronoi_sites.h>

#include <deal.II/base/exceptions.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/**
 * The distance of the guards from the middle of the domain, over its extent: a
 * third of it, by which the tetrahedron of the guards surrounds the middle, is
 * more than the diameter of the domain, and so is the distance of a point of
 * the domain from a guard.
 */
constexpr double guard_distance_in_space = 8.;

/** Directions to the guards: alternate corners of a cube. */
constexpr std::array<std::array<int, 3>, 4> guard_directions = {
    {{{1, 1, 1}}, {{1, -1, -1}}, {{-1, 1, -1}}, {{-1, -1, 1}}}};

/** Rounding errors of coordinates that are taken for none, in epsilons. */
constexpr double accepted_epsilons = 16.;

/**
 * The errors of the plain solution of three equations with unit rows, at most,
 * in epsilons of its parts over the determinant.
 */
constexpr double epsilons_of_solution = 16.;

/**
 * The distance from a plane, relative to the size of the domain, below which
 * the side is found in rational numbers: ten times that up to which corners of
 * the domain count as in the plane, and far more than rounding errors.
 */
constexpr double relative_doubt = 1e-8;

/** The same if the coordinates are larger, in rounding errors of these. */
constexpr double epsilons_of_doubt = 64.;

using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;

Exact::Point_3 exact_point(const Point<3> &p)
{
  return {Exact::FT(p[0]), Exact::FT(p[1]), Exact::FT(p[2])};
}

Exact::Plane_3 exact_plane(const ConvexPolyhedron &domain, const unsigned int k)
{
  const auto &corners = domain.plane(k).corners;
  const auto corner = [&](const unsigned int i) {
    return exact_point(domain.faces().vertices[corners[i]]);
  };
  return {corner(0), corner(1), corner(2)};
}

/** A vertex in rational numbers. */
Exact::Point_3 exact_vertex(const VoronoiSites &sites,
                            const ConvexPolyhedron &domain,
                            const VertexName &name)
{
  const Exact::Point_3 p = exact_point(sites.point(name[0]));
  if (!sites.is_plane(name[3]))
    return CGAL::circumcenter(p, exact_point(sites.point(name[1])),
                              exact_point(sites.point(name[2])),
                              exact_point(sites.point(name[3])));
  std::array<Exact::Plane_3, 3> planes;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const unsigned int site = name[i + 1];
    planes[i] = sites.is_plane(site)
                    ? exact_plane(domain, site - sites.n_points())
                    : CGAL::bisector(p, exact_point(sites.point(site)));
  }
  const auto common = CGAL::intersection(planes[0], planes[1], planes[2]);
  const Exact::Point_3 *const point =
      common ? held<Exact::Point_3>(*common) : nullptr;
  AssertThrow(point, dealii::ExcInternalError());
  return *point;
}
} // namespace

VoronoiSites::VoronoiSites(const std::vector<Point<3>> &generators,
                           const ConvexPolyhedron &domain)
    : domain(domain),
      doubtful_distance(
          std::max(relative_doubt * domain.extent(),
                   epsilons_of_doubt * std::numeric_limits<double>::epsilon() *
                       domain.largest_length()))
{
  points.reserve(generators.size() + n_guards);
  points = generators;
  const double distance = guard_distance_in_space * domain.extent();
  for (const auto &direction : guard_directions)
  {
    Point<3> guard = domain.middle();
    for (unsigned int d = 0; d < 3; ++d)
      guard[d] += direction[d] * distance / std::sqrt(3.);
    points.push_back(guard);
  }
}

Tensor<1, 3>
VoronoiSites::direction(const std::array<unsigned int, 2> &sides) const
{
  if (is_plane(sides[1]))
    return domain.plane(sides[1] - n_points()).normal;
  const Tensor<1, 3> across = points[sides[1]] - points[sides[0]];
  return across / across.norm();
}

Point<3> VoronoiSites::place(const VertexName &name) const
{
  if (is_plane(name[1]))
  {
    const unsigned int corner = domain.corner_in(
        {{name[1] - n_points(), name[2] - n_points(), name[3] - n_points()}});
    if (corner != invalid_index)
      return domain.faces().vertices[corner];
  }
  // Planes n x = b with unit vectors n, from the first generator on.
  const Point<3> &p = points[name[0]];
  std::array<Tensor<1, 3>, 3> n;
  std::array<double, 3> b;
  double largest = 0.;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const unsigned int site = name[i + 1];
    if (is_plane(site))
    {
      n[i] = domain.plane(site - n_points()).normal;
      b[i] = -domain.beyond(p, site - n_points());
    }
    else
    {
      n[i] = points[site] - p;
      const double distance = n[i].norm();
      n[i] /= distance;
      b[i] = 0.5 * distance;
    }
    largest = std::max(largest, std::abs(b[i]));
  }
  const Tensor<1, 3> c = cross_product_3d(n[1], n[2]);
  const double determinant = n[0] * c;
  const Tensor<1, 3> numerator = b[0] * c +
                                 b[1] * cross_product_3d(n[2], n[0]) +
                                 b[2] * cross_product_3d(n[0], n[1]);
  const double size = std::abs(determinant);
  // Both sides times the determinant, which may be zero.
  const bool is_accurate =
      epsilons_of_solution * (largest * size + numerator.norm()) <=
      accepted_epsilons * size * (domain.extent() * size + numerator.norm());
  Point<3> vertex;
  if (is_accurate && size > std::numeric_limits<double>::min())
    vertex = p + numerator / determinant;
  else
  {
    const Exact::Point_3 q = exact_vertex(*this, domain, name);
    vertex = {CGAL::to_double(q.x()), CGAL::to_double(q.y()),
              CGAL::to_double(q.z())};
  }
  for (unsigned int i = 1; i < 4; ++i)
    if (is_plane(name[i]))
    {
      const unsigned int k = name[i] - n_points();
      const unsigned int axis = domain.plane(k).axis;
      if (axis != invalid_index)
        vertex[axis] = domain.origin(k)[axis];
    }
  return vertex;
}

bool VoronoiSites::is_beyond(const VertexName &name,
                             const Point<3> &place,
                             const unsigned int k) const
{
  const double distance = domain.beyond(place, k);
  const double length = place.distance(domain.origin(k)) / domain.extent();
  if (std::abs(distance) > doubtful_distance * (1. + length))
    return distance > 0.;
  return exact_plane(domain, k).has_on_positive_side(
      exact_vertex(*this, domain, name));
}
} // namespace Voussoir
