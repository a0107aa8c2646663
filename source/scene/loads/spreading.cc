// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/scene/loads/spreading.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Voussoir
{
using dealii::Point;

namespace
{
/** Of the mean place of a force on an edge, whose rays are smooth. */
constexpr unsigned int n_points_on_edge = 12;

/** The difference of angles that is rounding; radians. */
constexpr double rounding_of_angles = 1e-14;

/** Angles from one to another. */
using AngleRange = std::pair<double, double>;

/** The parts of an interval that are in none of the others, which it joins. */
std::vector<AngleRange> seen_part(const AngleRange &of,
                                  std::vector<AngleRange> &covered)
{
  std::vector<AngleRange> left = {of};
  for (const auto &[a, b] : covered)
  {
    std::vector<AngleRange> rest;
    for (const auto &[c, d] : left)
    {
      if (c < std::min(d, a))
        rest.emplace_back(c, std::min(d, a));
      if (std::max(c, b) < d)
        rest.emplace_back(std::max(c, b), d);
    }
    left = std::move(rest);
  }
  covered.push_back(of);
  return left;
}

/** F. */
double up_to(const Spreading::Law law, const double angle)
{
  return law == Spreading::Law::uniform ? std::tan(angle)
                                        : angle + 0.5 * std::sin(2. * angle);
}

/** Its derivative. */
double density(const Spreading::Law law, const double angle)
{
  const double cosine = std::cos(angle);
  return law == Spreading::Law::uniform ? 1. / (cosine * cosine)
                                        : 2. * cosine * cosine;
}

/** Where a ray from @p from meets the line of an edge. */
Point<2> on_edge(const Packing<2>::BoundaryEdge &edge,
                 const Point<2> &from,
                 const double angle)
{
  const dealii::Tensor<1, 2> ray({std::sin(angle), -std::cos(angle)});
  const double along =
      ((edge.start - from) * edge.normal) / (ray * edge.normal);
  return from + along * ray;
}
} // namespace

std::vector<CellForce> Spreading::forces(const Packing<2> &packing,
                                         const double x,
                                         const double force) const
{
  std::vector<CellForce> all;
  if (law == Law::none)
    return all;
  const Point<2> from(x, top(x));
  struct Below
  {
    double distance;
    unsigned int edge;
    AngleRange angles;
  };
  std::vector<Below> below;
  for (unsigned int b = 0; b < edges.size(); ++b)
  {
    const Packing<2>::BoundaryEdge &edge = packing.boundary_edges()[b];
    // Those that look at the place, below it.
    if (!edges[b] || !((from - edge.midpoint()) * edge.normal > 0.) ||
        !(std::max(edge.start[1], edge.end[1]) < from[1]))
      continue;
    const auto angle = [&](const Point<2> &p) {
      return std::atan2(p[0] - from[0], from[1] - p[1]);
    };
    // Counterclockwise around its cell it runs to the left.
    const AngleRange angles = {std::max(angle(edge.end), -limit),
                               std::min(angle(edge.start), limit)};
    if (angles.first < angles.second - rounding_of_angles)
      below.push_back({from.distance(edge.midpoint()), b, angles});
  }
  std::sort(below.begin(), below.end(), [](const Below &one, const Below &two) {
    return one.distance < two.distance;
  });
  const dealii::QGauss<1> quadrature(n_points_on_edge);
  std::vector<AngleRange> covered;
  for (const Below &of : below)
    for (const auto &[a, b] : seen_part(of.angles, covered))
    {
      const Packing<2>::BoundaryEdge &edge = packing.boundary_edges()[of.edge];
      const double share =
          (up_to(law, b) - up_to(law, a)) / (2. * up_to(law, limit));
      Point<2> mean;
      double sum = 0.;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const double angle = a + (b - a) * quadrature.point(q)[0];
        const double weight = quadrature.weight(q) * density(law, angle);
        mean += weight * on_edge(edge, from, angle);
        sum += weight;
      }
      all.push_back({text("cell ", edge.cell),
                     {edge.cell},
                     dealii::Tensor<1, 2>({0., -share * force}),
                     Point<2>(mean / sum)});
    }
  return all;
}
} // namespace Voussoir
