// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/voronoi/point_source.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
using dealii::Point;

namespace
{
/**
 * The number of times that the bound in some simplex may be raised. Once or
 * twice is usual for a formula with a peak between the corners; a size that
 * vanishes would raise bounds for ever.
 */
constexpr unsigned int most_raised_bounds = 200;

/**
 * The number of points tried for each that is kept, on average, before the size
 * is taken to vanish somewhere: far more than bounds that fit ever cost.
 */
constexpr double most_tries = 100.;

/** The barycentric coordinates of the middle of a simplex, but one. */
template <int dim>
std::array<double, dim> middle_of_simplex()
{
  std::array<double, dim> parts;
  parts.fill(1. / (dim + 1.));
  return parts;
}

/** Barycentric coordinates, but one, of a point drawn from a triangle. */
std::array<double, 2> parts_drawn_by(Random &random, const Point<2> & /*in*/)
{
  double a = random(), b = random();
  if (a + b > 1.) // in the other half of the parallelogram
  {
    a = 1. - a;
    b = 1. - b;
  }
  return {{a, b}};
}

/** Those of a point drawn from a tetrahedron: gaps between ordered numbers. */
std::array<double, 3> parts_drawn_by(Random &random, const Point<3> & /*in*/)
{
  std::array<double, 3> ends;
  for (double &end : ends)
    end = random();
  std::sort(ends.begin(), ends.end());
  return {{ends[0], ends[1] - ends[0], ends[2] - ends[1]}};
}
} // namespace

template <int dim>
Point<dim> Simplex<dim>::at(const std::array<double, dim> &parts) const
{
  double rest = 1.;
  for (const double part : parts)
    rest -= part;
  Point<dim> p = rest * corners[0];
  for (unsigned int i = 0; i < dim; ++i)
    p += parts[i] * corners[i + 1];
  return p;
}

template <int dim>
void PointSource<dim>::add(const std::array<Point<dim>, dim + 1> &corners,
                           const double measure)
{
  Simplex<dim> simplex = {corners, measure, 0.};
  const double in_middle = density(simplex.at(middle_of_simplex<dim>()));
  double least = in_middle, largest = in_middle;
  for (const Point<dim> &corner : corners)
  {
    const double value = density(corner);
    least = std::min(least, value);
    largest = std::max(largest, value);
  }
  // Between these points the density may rise as much again.
  raise_bound(simplex, largest + (largest - least));
  simplices.push_back(simplex);
}

template <int dim>
std::vector<Point<dim>> PointSource<dim>::draw(const unsigned int n,
                                               const unsigned int seed)
{
  std::vector<Point<dim>> points(n);
  std::optional<Point<dim>> excess;
  for (unsigned int raised = 0; raised <= most_raised_bounds; ++raised)
  {
    excess = try_to_draw(points, seed);
    if (!excess)
      return points;
  }
  size.refuse_as_too_small(*excess);
}

template <int dim>
double PointSource<dim>::density(const Point<dim> &p) const
{
  const double ratio = reference_size / size(p);
  return dim == 2 ? ratio * ratio : ratio * ratio * ratio;
}

template <int dim>
void PointSource<dim>::raise_bound(Simplex<dim> &simplex,
                                   const double bound) const
{
  simplex.bound = bound;
  if (!std::isfinite(bound))
    size.refuse_as_too_small(simplex.at(middle_of_simplex<dim>()));
}

/**
 * Draw @p points.
 *
 * @return a point at which the bound was exceeded and is now raised; nothing if
 * all points were drawn.
 */
template <int dim>
std::optional<Point<dim>>
PointSource<dim>::try_to_draw(std::vector<Point<dim>> &points,
                              const unsigned int seed)
{
  std::vector<double> mass_up_to;
  double mass = 0.;
  for (const Simplex<dim> &simplex : simplices)
  {
    mass += simplex.measure * simplex.bound;
    mass_up_to.push_back(mass);
  }
  Random random(seed);
  double tries_left = most_tries * (points.size() + most_tries);
  for (Point<dim> &p : points)
    for (bool kept = false; !kept;)
    {
      const auto found = std::upper_bound(
          mass_up_to.begin(), mass_up_to.end() - 1, random() * mass);
      Simplex<dim> &simplex = simplices[found - mass_up_to.begin()];
      p = simplex.at(parts_drawn_by(random, p));
      const double value = density(p);
      if (--tries_left < 0.)
        size.refuse_as_too_small(p);
      if (value > simplex.bound)
      {
        raise_bound(simplex, 2. * value);
        return p;
      }
      kept = random() * simplex.bound < value;
    }
  return {};
}

template struct Simplex<2>;
template struct Simplex<3>;
template class PointSource<2>;
template class PointSource<3>;
} // namespace Voussoir
