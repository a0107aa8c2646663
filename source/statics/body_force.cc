// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/geometry.h>
#include <voussoir/statics/body_force.h>

#include <deal.II/base/quadrature_lib.h>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** deal.II's rule of this number has seven points and degree five. */
constexpr unsigned int rule_on_triangles = 3;

/** A sub-cell: the triangle of the centre and side i of a cell. */
struct Triangle
{
  Triangle(const Packing &packing, const unsigned int c, const unsigned int i)
      : a(packing.vertex(c, i) - packing.centre(c)),
        b(packing.vertex(c, i + 1) - packing.centre(c)), area(0.5 * cross(a, b))
  {
  }

  /** The corners, from the centre. */
  Tensor<1, 2> a, b;
  double area;
};
} // namespace

BodyForce::BodyForce(
    const Packing &packing,
    const std::function<Tensor<1, 2>(const Point<2> &, unsigned int)> &b)
{
  allocate(packing);
  const dealii::QGaussSimplex<2> rule(rule_on_triangles);
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
    {
      const Triangle triangle(packing, c, i);
      for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const Tensor<1, 2> arm =
            rule.point(q)[0] * triangle.a + rule.point(q)[1] * triangle.b;
        // The weights of the rule add up to the area of its triangle, 1/2.
        const Tensor<1, 2> force =
            2. * rule.weight(q) * triangle.area * b(packing.centre(c) + arm, c);
        on_sub_cell[packing.first_side(c) + i] += force;
        moment_of_cell[c] += outer_product(force, arm);
      }
    }
}

void BodyForce::add(const Packing &packing,
                    const unsigned int cell,
                    const Tensor<1, 2> &f)
{
  if (empty())
    allocate(packing);
  for (unsigned int i = 0; i < packing.n_sides(cell); ++i)
  {
    const Triangle triangle(packing, cell, i);
    const Tensor<1, 2> share = triangle.area / packing.area(cell) * f;
    on_sub_cell[packing.first_side(cell) + i] += share;
    moment_of_cell[cell] +=
        outer_product(share, (triangle.a + triangle.b) / 3.);
  }
}

void BodyForce::allocate(const Packing &packing)
{
  on_sub_cell.resize(packing.first_side(packing.n_cells()));
  moment_of_cell.resize(packing.n_cells());
}

bool BodyForce::empty() const
{
  return on_sub_cell.empty();
}

Tensor<1, 2> BodyForce::force(const Packing &packing,
                              const unsigned int cell) const
{
  Tensor<1, 2> sum;
  for (unsigned int i = 0; i < packing.n_sides(cell); ++i)
    sum += force(packing, cell, i);
  return sum;
}

Tensor<1, 2> BodyForce::force(const Packing &packing,
                              const unsigned int cell,
                              const unsigned int i) const
{
  return empty() ? Tensor<1, 2>() : on_sub_cell[packing.first_side(cell) + i];
}

Tensor<2, 2> BodyForce::moment(const unsigned int cell) const
{
  return empty() ? Tensor<2, 2>() : moment_of_cell[cell];
}
} // namespace Voussoir
