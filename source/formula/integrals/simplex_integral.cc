// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/formula/integrals/simplex_integral.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Voussoir
{

using SimplexCorners = std::vector<dealii::Point<3>>;

namespace
{
/** Of triangles, and of tetrahedra. */
constexpr unsigned int most_halvings = 20, most_halvings_of_four = 18;
/** The error, over the size of the values, that is rounding. */
constexpr double rounding_of_rules = 1e-12;

/** A rule by the shares of the corners in its points. */
struct BarycentricRule
{
  struct Place
  {
    std::array<double, 4> shares;
    /** Over the measure of the simplex. */
    double weight;
  };
  std::vector<Place> places;
};

template <int dim>
BarycentricRule rule_of(const unsigned int n_points_1D)
{
  const dealii::QWitherdenVincentSimplex<dim> quadrature(n_points_1D);
  double sum = 0.;
  for (const double weight : quadrature.get_weights())
    sum += weight;
  BarycentricRule rule;
  for (unsigned int q = 0; q < quadrature.size(); ++q)
  {
    BarycentricRule::Place place = {{{1., 0., 0., 0.}},
                                    quadrature.weight(q) / sum};
    for (unsigned int i = 0; i < dim; ++i)
    {
      place.shares[i + 1] = quadrature.point(q)[i];
      place.shares[0] -= quadrature.point(q)[i];
    }
    rule.places.push_back(place);
  }
  return rule;
}

double simplex_measure(const SimplexCorners &corners)
{
  const auto a = corners[1] - corners[0], b = corners[2] - corners[0];
  const auto normal = cross_product_3d(a, b);
  return corners.size() == 3
             ? 0.5 * normal.norm()
             : std::abs(normal * (corners[3] - corners[0])) / 6.;
}

/** The numbers of the ends of the longest edge. */
std::pair<unsigned int, unsigned int>
longest_edge(const SimplexCorners &corners)
{
  std::pair<unsigned int, unsigned int> found(0, 1);
  double longest = 0.;
  for (unsigned int i = 0; i < corners.size(); ++i)
    for (unsigned int j = i + 1; j < corners.size(); ++j)
      if (const double length = corners[i].distance(corners[j]);
          length > longest)
      {
        longest = length;
        found = {i, j};
      }
  return found;
}

using SimplexIntegrand =
    std::function<void(const dealii::Point<3> &, IntegratedValues &)>;

void apply_rule(const BarycentricRule &rule,
                const SimplexCorners &corners,
                const SimplexIntegrand &f,
                IntegratedValues &sum,
                double &size)
{
  const double measure = simplex_measure(corners);
  IntegratedValues values;
  for (const BarycentricRule::Place &place : rule.places)
  {
    dealii::Point<3> x;
    for (unsigned int i = 0; i < corners.size(); ++i)
      x += place.shares[i] * corners[i];
    f(x, values);
    sum.resize(values.size(), 0.);
    double largest = 0.;
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      sum[k] += place.weight * measure * values[k];
      largest = std::max(largest, std::abs(values[k]));
    }
    size += place.weight * measure * largest;
  }
}

SimplexIntegral integrate_halves(const SimplexCorners &corners,
                                 const SimplexIntegrand &f,
                                 const unsigned int n_halvings)
{
  static const BarycentricRule fine_of_triangle = rule_of<2>(5),
                               coarse_of_triangle = rule_of<2>(3),
                               fine_of_tetrahedron = rule_of<3>(5),
                               coarse_of_tetrahedron = rule_of<3>(3);
  const bool is_triangle = corners.size() == 3;
  SimplexIntegral fine;
  IntegratedValues coarse;
  double size_of_coarse = 0.;
  apply_rule(is_triangle ? fine_of_triangle : fine_of_tetrahedron, corners, f,
             fine.values, fine.size);
  apply_rule(is_triangle ? coarse_of_triangle : coarse_of_tetrahedron, corners,
             f, coarse, size_of_coarse);
  for (std::size_t k = 0; k < coarse.size(); ++k)
    fine.error = std::max(fine.error, std::abs(fine.values[k] - coarse[k]));
  const unsigned int most = is_triangle ? most_halvings : most_halvings_of_four;
  if (!(fine.error > rounding_of_rules * fine.size) || n_halvings == most)
  {
    if (n_halvings < most)
      fine.error = 0.;
    return fine;
  }
  const auto [i, j] = longest_edge(corners);
  const dealii::Point<3> middle(0.5 * (corners[i] + corners[j]));
  SimplexIntegral sum;
  for (const unsigned int k : {i, j})
  {
    SimplexCorners half = corners;
    half[k] = middle;
    sum.add(integrate_halves(half, f, n_halvings + 1));
  }
  return sum;
}
} // namespace

void SimplexIntegral::add(const SimplexIntegral &other)
{
  values.resize(other.values.size(), 0.);
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] += other.values[k];
  error += other.error;
  size += other.size;
}

SimplexIntegral integral_over_simplex(const SimplexCorners &corners,
                                      const SimplexIntegrand &f)
{
  return integrate_halves(corners, f, 0);
}
} // namespace Voussoir
