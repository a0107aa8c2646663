// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/stress/cell_stress.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

/**
 * The area of a triangle over the square of its longest side below which the
 * rounding of the coordinates begins to decide its shape.
 */
constexpr double least_slenderness = 1e-11;

/**
 * The slenderness below which the stress is checked in the cell turned: at
 * worst rounding over its square is lost, here 1e-10.
 */
constexpr double doubtful_slenderness = 1e-3;

/** The angle for that: any that is no symmetry of a cell. */
constexpr double turn = 1.;

/**
 * The error of the mean of the stress against the forces, and of the stress of
 * a sub-cell against that of the cell turned, relative to largest_stress().
 */
constexpr double largest_error = 1e-6;

Tensor<2, 2> LoadedCell::moments() const
{
  Tensor<2, 2> sum;
  const unsigned int n = vertices.size();
  for (unsigned int i = 0; i < n; ++i)
  {
    const Tensor<1, 2> a = vertices[i] - centre;
    const Tensor<1, 2> b = vertices[(i + 1) % n] - centre;
    sum += outer_product(forces[i], 0.5 * (a + b)) +
           outer_product(body_forces[i], (a + b) / 3.);
    if (!shifts.empty())
      sum += outer_product(shifts[i], 0.5 * side(i));
  }
  return sum;
}

CellStress::CellStress(const SubTriangulation &cut,
                       const unsigned int n_sides,
                       const unsigned int degree,
                       const bool with_flux_mass)
    : spaces(cut, n_sides, degree), with_flux_mass(with_flux_mass),
      n_per_side(cut.of_triangle().size())
{}

bool CellStress::solve(const LoadedCell &cell,
                       const dealii::ArrayView<SubCellStress> &sub_cells)
{
  AssertDimension(cell.vertices.size() * n_per_side, n_sub_cells());
  AssertDimension(cell.forces.size(), cell.vertices.size());
  AssertDimension(cell.body_forces.size(), cell.vertices.size());
  Assert(cell.shifts.empty() || cell.shifts.size() == cell.forces.size(),
         dealii::ExcDimensionMismatch(cell.shifts.size(), cell.forces.size()));
  AssertDimension(sub_cells.size(), n_sub_cells());

  if (!solve_once(cell, found))
    return false;
  if (slenderness < doubtful_slenderness && !is_same_turned(cell))
    return false;
  std::copy(found.begin(), found.end(), sub_cells.begin());
  return true;
}

bool CellStress::solve_once(const LoadedCell &cell,
                            std::vector<SubCellStress> &result)
{
  if (!scale(cell))
    return false;
  take_out_mean(cell);
  spaces.place(corners, with_flux_mass);
  if (!find_fluxes() || !mean_is_right())
    return false;
  result.clear();
  for (unsigned int s = 0; s < n_sub_cells(); ++s)
    result.push_back(stress_in(s));
  return true;
}

SubCellStress CellStress::stress_in(const unsigned int s) const
{
  const unsigned int n_fluxes = spaces.n_fluxes_per_sub_cell();
  const CellSpaces::Integrals &integrals = spaces.integrals(s);
  SubCellStress result;
  for (unsigned int row = 0; row < 2; ++row)
  {
    for (unsigned int k = 0; k < n_fluxes; ++k)
    {
      const double c = coefficient(row, s, k);
      result.stress[row] += c * integrals.in_the_middle[k];
      for (unsigned int j = 0; j < integrals.mean.size(); ++j)
        result.divergence[row] += c * spaces.divergence(s, j, k);
    }
    result.divergence[row] /= integrals.area * size;
  }
  double skew_square = 0.;
  for (unsigned int q = 0; q < integrals.weights.size(); ++q)
  {
    double skew = 0.;
    for (unsigned int k = 0; k < n_fluxes; ++k)
      skew += 0.5 * (coefficient(0, s, k) * integrals.at_points(q, k)[1] -
                     coefficient(1, s, k) * integrals.at_points(q, k)[0]);
    skew_square += integrals.weights[q] * skew * skew;
  }
  result.skew = std::sqrt(skew_square / integrals.area);
  result.stress += mean;
  return result;
}

/**
 * Scale the cell to unit area, so that all coefficients are of order one.
 *
 * @return false if a triangle is too slender.
 */
bool CellStress::scale(const LoadedCell &cell)
{
  const unsigned int n_sides = cell.vertices.size();
  double area = 0.;
  slenderness = std::numeric_limits<double>::infinity();
  for (unsigned int i = 0; i < n_sides; ++i)
  {
    const Tensor<1, 2> a = cell.vertices[i] - cell.centre;
    const Tensor<1, 2> b = cell.vertices[(i + 1) % n_sides] - cell.centre;
    const double triangle = 0.5 * cross(a, b);
    const double longest =
        std::max({a.norm_square(), b.norm_square(), (b - a).norm_square()});
    if (!(triangle > least_slenderness * longest))
      return false;
    slenderness = std::min(slenderness, triangle / longest);
    area += triangle;
  }
  size = std::sqrt(area);
  corners.clear();
  for (const Point<2> &vertex : cell.vertices)
    corners.emplace_back((vertex - cell.centre) / size);
  return true;
}

/** Leave in forces what the symmetric mean stress does not account for. */
void CellStress::take_out_mean(const LoadedCell &cell)
{
  const unsigned int n_sides = cell.vertices.size();
  mean = Tensor<2, 2>();
  forces.clear();
  sources.clear();
  for (unsigned int i = 0; i < n_sides; ++i)
  {
    const Point<2> &a = corners[i];
    const Point<2> &b = corners[(i + 1) % n_sides];
    const Tensor<1, 2> source = cell.body_forces[i] / size;
    const Tensor<1, 2> force = cell.forces[i] / size;
    sources.push_back(source / (0.5 * cross(a, b)));
    mean += outer_product(force, 0.5 * (a + b)) +
            outer_product(source, (a + b) / 3.);
    forces.insert(forces.end(), 2, 0.5 * force);
    if (cell.shifts.empty())
      continue;
    const Tensor<1, 2> shift = cell.shifts[i] / size;
    mean += outer_product(shift, 0.5 * (b - a));
    forces[2 * i] -= shift;
    forces[2 * i + 1] += shift;
  }
  mean = symmetrize(mean);
  for (unsigned int i = 0; i < n_sides; ++i)
  {
    // From the vertices, since corners have the rounding of the whole cell,
    // which on a short side is a large traction.
    const Tensor<1, 2> half = 0.5 * (cell.side(i) / size);
    const Tensor<1, 2> of_mean = mean * Tensor<1, 2>({half[1], -half[0]});
    forces[2 * i] -= of_mean;
    forces[2 * i + 1] -= of_mean;
  }
}

/** Of the symmetric mean and of the tractions that remain. */
double CellStress::largest_stress() const
{
  double largest = mean.norm();
  for (unsigned int h = 0; h < forces.size(); ++h)
  {
    const unsigned int i = h / 2;
    largest = std::max(
        largest,
        forces[h].norm() /
            (0.5 * corners[i].distance(corners[(i + 1) % corners.size()])));
  }
  return largest;
}

/**
 * The integral of sigma_ri over the cell is that of sigma n x_i over its sides
 * less that of div sigma x_i: a check on what rounding has left of the fluxes,
 * computed from other integrals than these were found with.
 */
bool CellStress::mean_is_right() const
{
  Tensor<2, 2> error;
  for (unsigned int i = 0; i < corners.size(); ++i)
  {
    const Point<2> &a = corners[i];
    const Point<2> &b = corners[(i + 1) % corners.size()];
    const Tensor<1, 2> &first = forces[2 * i], &second = forces[2 * i + 1];
    error -= outer_product(first + second, 0.5 * (a + b)) +
             outer_product(second - first, 0.25 * (b - a));
  }
  for (unsigned int s = 0; s < n_sub_cells(); ++s)
  {
    const CellSpaces::Integrals &integrals = spaces.integrals(s);
    for (unsigned int row = 0; row < 2; ++row)
      for (unsigned int k = 0; k < spaces.n_fluxes_per_sub_cell(); ++k)
      {
        const double c = coefficient(row, s, k);
        for (unsigned int j = 0; j < integrals.mean.size(); ++j)
          error[row] += c * (integrals.moment(j, k) +
                             spaces.divergence(s, j, k) * integrals.nodes[j]);
      }
  }
  return error.norm() <= largest_error * largest_stress();
}

/**
 * True if the stress that was found comes back in the cell turned, with the
 * forces on it. A check of all that rounding does, in the equations as in their
 * solution, and of each sub-cell.
 */
bool CellStress::is_same_turned(const LoadedCell &cell)
{
  Tensor<2, 2> rotation;
  rotation[0][0] = rotation[1][1] = std::cos(turn);
  rotation[1][0] = std::sin(turn);
  rotation[0][1] = -rotation[1][0];
  LoadedCell turned;
  for (unsigned int i = 0; i < cell.vertices.size(); ++i)
  {
    turned.vertices.emplace_back(rotation * (cell.vertices[i] - cell.centre));
    turned.forces.push_back(rotation * cell.forces[i]);
    turned.body_forces.push_back(rotation * cell.body_forces[i]);
    if (!cell.shifts.empty())
      turned.shifts.push_back(rotation * cell.shifts[i]);
  }
  if (!solve_once(turned, found_turned))
    return false;
  const double largest = largest_stress();
  for (unsigned int s = 0; s < n_sub_cells(); ++s)
  {
    const Tensor<2, 2> turned_back =
        transpose(rotation) * found_turned[s].stress * rotation;
    if (!((found[s].stress - turned_back).norm() <=
          largest_error * std::max(largest, found[s].stress.norm())))
      return false;
  }
  return true;
}
} // namespace Voussoir
