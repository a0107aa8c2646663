// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/stress/fan.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_raviart_thomas.h>
#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
constexpr unsigned int none = dealii::numbers::invalid_unsigned_int;

/** Gauss points per direction: exact for tau : j(p). */
constexpr unsigned int n_gauss_points = 2;

/** Ratio of the pivots of B B^T below which a cell counts as undetermined. */
constexpr double smallest_pivot_ratio = 1e-12;

/**
 * The area of a sub-cell over the square of its longest side below which the
 * rounding of the coordinates begins to decide its shape.
 */
constexpr double least_slenderness = 1e-11;

/** Gauss points, and last the reference centre, of weight zero. */
dealii::Quadrature<2> quadrature_with_centre()
{
  const dealii::QGauss<2> gauss(n_gauss_points);
  std::vector<Point<2>> points = gauss.get_points();
  std::vector<double> weights = gauss.get_weights();
  points.emplace_back(0.5, 0.5);
  weights.push_back(0.);
  return {points, weights};
}
} // namespace

std::array<Point<2>, 4> fan_sub_cell(const Point<2> &centre,
                                     const Point<2> &vertex_i,
                                     const Point<2> &vertex_j)
{
  return {{centre, vertex_i, vertex_j, vertex_i + 0.5 * (vertex_j - vertex_i)}};
}

Fan::Fan(const unsigned int n_sides)
    : n_sides(n_sides),
      element(dealii::FE_RaviartThomas<2>(0), 2, dealii::FE_DGQ<2>(0), 1),
      fe_values(element,
                quadrature_with_centre(),
                dealii::update_values | dealii::update_JxW_values)
{
  centre_point = fe_values.n_quadrature_points - 1;
  make_triangulation();
  dof_handler.reinit(triangulation);
  dof_handler.distribute_dofs(element);
  number_unknowns();
  matrix.reinit(n_fluxes() + n_sides);
  gram.reinit(n_sides);
  gram.set_property(dealii::LAPACKSupport::symmetric);
  solution.reinit(n_fluxes() + n_sides);
}

/** A fan in a regular polygon: vertex 0 is the centre, then corners, midpoints.
 */
void Fan::make_triangulation()
{
  std::vector<Point<2>> corners(n_sides);
  for (unsigned int i = 0; i < n_sides; ++i)
  {
    const double angle = 2. * dealii::numbers::PI * i / n_sides;
    corners[i] = {std::cos(angle), std::sin(angle)};
  }
  std::vector<Point<2>> vertices = {Point<2>()};
  vertices.insert(vertices.end(), corners.begin(), corners.end());
  std::vector<dealii::CellData<2>> cells(n_sides);
  for (unsigned int i = 0; i < n_sides; ++i)
  {
    const unsigned int j = (i + 1) % n_sides;
    vertices.push_back(fan_sub_cell({}, corners[i], corners[j])[3]);
    cells[i].vertices = {0, 1 + i, 1 + j, 1 + n_sides + i};
  }
  triangulation.create_triangulation(vertices, cells, dealii::SubCellData());
}

void Fan::number_unknowns()
{
  dealii::FEValues<2> regular(element, dealii::QGauss<2>(n_gauss_points),
                              dealii::update_gradients |
                                  dealii::update_JxW_values);
  unsigned int n_found = 0;
  std::vector<unsigned int> unknown(dof_handler.n_dofs(), none);
  std::vector<dealii::types::global_dof_index> indices(element.dofs_per_cell);

  local_dofs.reserve(n_sides * element.dofs_per_cell);
  for (const auto &cell : dof_handler.active_cell_iterators())
  {
    regular.reinit(cell);
    cell->get_dof_indices(indices);
    for (unsigned int k = 0; k < element.dofs_per_cell; ++k)
    {
      // In FE_RaviartThomas(0), number k within the element is that of a face.
      const auto [base, face] = element.system_to_base_index(k);
      LocalDof dof = {base.first == 1, base.second, none, 0.};
      if (!dof.is_multiplier)
      {
        const dealii::FEValuesExtractors::Vector row(2 * dof.row);
        for (unsigned int q = 0; q < regular.n_quadrature_points; ++q)
          dof.outward_flux += regular[row].divergence(k, q) * regular.JxW(q);
        dof.outward_flux = std::round(dof.outward_flux); // 1 or -1
      }
      // Fluxes through spokes come first, then the multipliers.
      if (dof.is_multiplier)
        dof.unknown = n_fluxes() + cell->active_cell_index();
      else if (!cell->face(face)->at_boundary())
      {
        if (unknown[indices[k]] == none)
          unknown[indices[k]] = n_found++;
        dof.unknown = unknown[indices[k]];
      }
      local_dofs.push_back(dof);
    }
  }
}

bool Fan::solve(const Point<2> &centre,
                const std::vector<Point<2>> &vertices,
                const std::vector<Tensor<1, 2>> &forces,
                const std::vector<Tensor<1, 2>> &body_forces,
                const dealii::ArrayView<SubCell> &sub_cells)
{
  AssertDimension(vertices.size(), n_sides);
  AssertDimension(forces.size(), n_sides);
  AssertDimension(body_forces.size(), n_sides);
  AssertDimension(sub_cells.size(), n_sides);

  // Work in a cell of unit area, so that all coefficients are of order one.
  double area = 0.;
  for (unsigned int i = 0; i < n_sides; ++i)
  {
    const Tensor<1, 2> a = vertices[i] - centre;
    const Tensor<1, 2> b = vertices[(i + 1) % n_sides] - centre;
    const double triangle = 0.5 * (a[0] * b[1] - a[1] * b[0]);
    if (!(triangle >
          least_slenderness * std::max({a.norm_square(), b.norm_square(),
                                        (b - a).norm_square()})))
      return false;
    area += triangle;
  }
  const double size = std::sqrt(area);
  std::vector<Tensor<1, 2>> fluxes(forces);
  for (Tensor<1, 2> &flux : fluxes)
    flux /= 2. * size; // through each half of a side

  std::vector<Tensor<1, 2>> sources(body_forces);
  for (Tensor<1, 2> &source : sources)
    source /= size;

  place(centre, vertices, size);
  assemble(fluxes, sources);
  if (!is_determined())
    return false;
  matrix.compute_lu_factorization();
  matrix.solve(solution);

  auto cell = dof_handler.begin_active();
  for (unsigned int i = 0; i < n_sides; ++i, ++cell)
  {
    fe_values.reinit(cell);
    double sub_area = 0.;
    for (unsigned int q = 0; q < centre_point; ++q)
      sub_area += fe_values.JxW(q);
    SubCell result;
    for (unsigned int k = 0; k < element.dofs_per_cell; ++k)
    {
      const LocalDof &dof = local_dofs[i * element.dofs_per_cell + k];
      if (dof.is_multiplier)
        continue;
      const double c = coefficient(dof, fluxes[i]);
      const dealii::FEValuesExtractors::Vector row(2 * dof.row);
      result.stress[dof.row] += c * fe_values[row].value(k, centre_point);
      result.divergence[dof.row] += c * dof.outward_flux / (sub_area * size);
    }
    sub_cells[i] = result;
  }
  return true;
}

void Fan::place(const Point<2> &centre,
                const std::vector<Point<2>> &vertices,
                const double size)
{
  const auto scaled = [&](const Point<2> &p) {
    return Point<2>((p - centre) / size);
  };
  unsigned int i = 0;
  for (const auto &cell : triangulation.active_cell_iterators())
  {
    const auto corners = fan_sub_cell({}, scaled(vertices[i]),
                                      scaled(vertices[(i + 1) % n_sides]));
    for (unsigned int v = 0; v < corners.size(); ++v)
      cell->vertex(v) = corners[v];
    ++i;
  }
  // FEValues must not take the moved cells for those it has seen.
  triangulation.signals.mesh_movement();
}

/** The value of a degree of freedom, once the system is solved. */
double Fan::coefficient(const LocalDof &dof, const Tensor<1, 2> &flux) const
{
  return dof.unknown == none ? dof.outward_flux * flux[dof.row]
                             : solution[dof.unknown];
}

void Fan::assemble(const std::vector<Tensor<1, 2>> &fluxes,
                   const std::vector<Tensor<1, 2>> &sources)
{
  const dealii::FEValuesExtractors::Scalar multiplier(4);
  const unsigned int n_local = element.dofs_per_cell;
  matrix = 0.;
  solution = 0.; // holds the right hand side until solve

  auto cell = dof_handler.begin_active();
  for (unsigned int i = 0; i < n_sides; ++i, ++cell)
  {
    fe_values.reinit(cell);
    const LocalDof *dofs = &local_dofs[i * n_local];

    const auto add = [&](const unsigned int test, const unsigned int trial,
                         const double value) {
      if (dofs[test].unknown == none)
        return;
      if (dofs[trial].unknown == none)
        solution[dofs[test].unknown] -=
            value * coefficient(dofs[trial], fluxes[i]);
      else
        matrix(dofs[test].unknown, dofs[trial].unknown) += value;
    };

    // The divergence of a basis function of unit flux is +-1 / det J, and det J
    // the area of the sub-cell times a function of the reference coordinates
    // that is the same in all. So the integral of the product of two is +-1
    // over the area times a common factor, which the minimiser does not see;
    // without it the divergence is compared with the body force in the mean
    // over each sub-cell. From the derivatives of the basis functions the same
    // would come out with a rounding error that ruins slender sub-cells.
    double area = 0.;
    for (unsigned int q = 0; q < centre_point; ++q)
      area += fe_values.JxW(q);

    for (unsigned int k = 0; k < n_local; ++k)
    {
      if (dofs[k].is_multiplier)
        continue;
      const dealii::FEValuesExtractors::Vector row(2 * dofs[k].row);
      if (dofs[k].unknown != none)
        solution[dofs[k].unknown] -=
            dofs[k].outward_flux * sources[i][dofs[k].row] / area;
      for (unsigned int l = 0; l < n_local; ++l)
        if (!dofs[l].is_multiplier && dofs[l].row == dofs[k].row)
          add(k, l, dofs[k].outward_flux * dofs[l].outward_flux / area);
        else if (dofs[l].is_multiplier)
        {
          double integral = 0.; // tau : j(p)
          for (unsigned int q = 0; q < centre_point; ++q)
          {
            const Tensor<1, 2> tau = fe_values[row].value(k, q);
            integral += (dofs[k].row == 0 ? tau[1] : -tau[0]) *
                        fe_values[multiplier].value(l, q) * fe_values.JxW(q);
          }
          add(k, l, integral);
          add(l, k, integral);
        }
    }
  }
}

/**
 * Whether the equations (sigma, j(q)) = 0 are independent in the free fluxes:
 * by the pivots of B B^T, with their matrix B. Unlike the pivots of the whole
 * system these do not see the weight 1/|sub-cell| of div sigma, which is large
 * along a short side and harmless.
 */
bool Fan::is_determined()
{
  gram = 0.; // also forgets the factorisation of the cell before
  for (unsigned int i = 0; i < n_sides; ++i)
    for (unsigned int j = 0; j <= i; ++j)
    {
      double product = 0.;
      for (unsigned int k = 0; k < n_fluxes(); ++k)
        product += matrix(n_fluxes() + i, k) * matrix(n_fluxes() + j, k);
      gram.set(i, j, product);
      gram.set(j, i, product);
    }
  try
  {
    gram.compute_cholesky_factorization();
  }
  catch (const dealii::LACExceptions::ExcSingular &)
  {
    return false;
  }
  double smallest = std::numeric_limits<double>::infinity(), largest = 0.;
  for (unsigned int i = 0; i < n_sides; ++i)
  {
    const double pivot = gram(i, i) * gram(i, i);
    smallest = std::min(smallest, pivot);
    largest = std::max(largest, pivot);
  }
  return smallest > smallest_pivot_ratio * largest;
}
} // namespace Voussoir
