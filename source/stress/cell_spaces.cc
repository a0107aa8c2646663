// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/base/invalid_index.h>
#include <voussoir/stress/cell_spaces.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>
#include <deal.II/lac/full_matrix.h>

#include <cmath>
#include <map>
#include <utility>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** The Gauss points, and last the middle, of weight zero. */
dealii::Quadrature<2> with_middle(const dealii::Quadrature<2> &gauss)
{
  std::vector<Point<2>> points = gauss.get_points();
  std::vector<double> weights = gauss.get_weights();
  points.emplace_back(0.5, 0.5);
  weights.push_back(0.);
  return {points, weights};
}

/** A regular polygon around the origin. */
std::vector<Point<2>> regular_polygon(const unsigned int n_sides)
{
  std::vector<Point<2>> vertices;
  for (unsigned int i = 0; i < n_sides; ++i)
  {
    const double angle = 2. * dealii::numbers::PI * i / n_sides;
    vertices.emplace_back(std::cos(angle), std::sin(angle));
  }
  return vertices;
}
/**
 * The coefficients of the basis functions on a face for which the normal trace
 * is one over its length; in the reference square they are the same for every
 * shape of the cell.
 */
dealii::Vector<double> even_flux(const dealii::FEFaceValues<2> &on_face,
                                 const unsigned int face)
{
  const dealii::FiniteElement<2> &element = on_face.get_fe();
  const dealii::FEValuesExtractors::Vector row(0);
  const unsigned int n = element.dofs_per_face;
  double length = 0.;
  for (unsigned int q = 0; q < n; ++q)
    length += on_face.JxW(q);
  dealii::FullMatrix<double> trace(n, n);
  for (unsigned int q = 0; q < n; ++q)
    for (unsigned int f = 0; f < n; ++f)
      trace(q, f) = on_face[row].value(element.face_to_cell_index(f, face), q) *
                    on_face.normal_vector(q);
  trace.gauss_jordan();
  dealii::Vector<double> coefficients(n), even(n);
  even = 1. / length;
  trace.vmult(coefficients, even);
  return coefficients;
}
} // namespace

CellSpaces::CellSpaces(const SubTriangulation &cut,
                       const unsigned int n_sides,
                       const unsigned int degree)
    : cut(cut), element(degree), multiplier(degree), gauss(degree + 2),
      points(with_middle(gauss))
{
  multipliers.reinit(multiplier.dofs_per_cell, gauss.size());
  for (unsigned int j = 0; j < multiplier.dofs_per_cell; ++j)
    for (unsigned int q = 0; q < gauss.size(); ++q)
      multipliers(j, q) = multiplier.shape_value(j, gauss.point(q));
  reference_values.reinit(points.size(), element.dofs_per_cell);
  for (unsigned int q = 0; q < points.size(); ++q)
    for (unsigned int k = 0; k < element.dofs_per_cell; ++k)
      for (unsigned int d = 0; d < 2; ++d)
        reference_values(q, k)[d] =
            element.shape_value_component(k, points.point(q), d);

  Integrals sample;
  sample.mean.resize(multiplier.dofs_per_cell);
  sample.mass.reinit(multiplier.dofs_per_cell, multiplier.dofs_per_cell);
  sample.moment.reinit(multiplier.dofs_per_cell, element.dofs_per_cell);
  sample.flux_mass.reinit(element.dofs_per_cell, element.dofs_per_cell);
  sample.nodes.resize(multiplier.dofs_per_cell);
  sample.in_the_middle.resize(element.dofs_per_cell);
  sample.at_points.reinit(gauss.size(), element.dofs_per_cell);
  sample.weights.resize(gauss.size());
  all_integrals.assign(n_sides * cut.of_triangle().size(), sample);

  dealii::Triangulation<2> triangulation;
  make_triangulation(triangulation, n_sides);
  dealii::DoFHandler<2> dof_handler(triangulation);
  dof_handler.distribute_dofs(element);
  find_divergences(dof_handler);
  prescribe_fluxes(dof_handler, n_sides);
  number_fluxes(dof_handler);
  find_orientations(dof_handler, n_sides);
}

/**
 * Vertices on a spoke belong to the triangles on both of its sides, and the
 * centre to all.
 */
void CellSpaces::make_triangulation(dealii::Triangulation<2> &triangulation,
                                    const unsigned int n_sides) const
{
  using Key = std::pair<unsigned int, std::pair<double, double>>;
  std::map<Key, unsigned int> numbers;
  std::vector<Point<2>> vertices;
  std::vector<dealii::CellData<2>> cells;
  const std::vector<Point<2>> polygon = regular_polygon(n_sides);
  for (unsigned int i = 0; i < n_sides; ++i)
  {
    const unsigned int next = (i + 1) % n_sides;
    for (unsigned int k = 0; k < cut.of_triangle().size(); ++k)
    {
      const auto corners = cut.corners(k, {}, polygon[i], polygon[next]);
      dealii::CellData<2> cell;
      for (unsigned int v = 0; v < corners.size(); ++v)
      {
        const auto [a, b] = cut.of_triangle()[k][v];
        const Key key = a == 0. && b == 0. ? Key(0, {0., 0.})
                        : a == 0.          ? Key(next, {b, 0.})
                                           : Key(i, {a, b});
        const auto [entry, is_new] = numbers.emplace(key, vertices.size());
        if (is_new)
          vertices.push_back(corners[v]);
        cell.vertices[v] = entry->second;
      }
      cells.push_back(cell);
    }
  }
  triangulation.create_triangulation(vertices, cells, dealii::SubCellData());
}

void CellSpaces::find_divergences(const dealii::DoFHandler<2> &dof_handler)
{
  const unsigned int n_multipliers = multiplier.dofs_per_cell;
  const dealii::FEValuesExtractors::Vector row(0);
  dealii::FEValues<2> inside(
      element, gauss, dealii::update_gradients | dealii::update_JxW_values);
  divergences.reinit(n_sub_cells() * n_multipliers, element.dofs_per_cell);
  for (const auto &cell : dof_handler.active_cell_iterators())
  {
    inside.reinit(cell);
    const unsigned int first = cell->active_cell_index() * n_multipliers;
    for (unsigned int k = 0; k < element.dofs_per_cell; ++k)
      for (unsigned int j = 0; j < n_multipliers; ++j)
        for (unsigned int q = 0; q < gauss.size(); ++q)
          divergences(first + j, k) +=
              multipliers(j, q) * inside[row].divergence(k, q) * inside.JxW(q);
  }
}

/** Set the fluxes through the faces of sub-cells that lie on a side. */
void CellSpaces::prescribe_fluxes(const dealii::DoFHandler<2> &dof_handler,
                                  const unsigned int n_sides)
{
  fluxes.assign(n_sub_cells() * element.dofs_per_cell,
                {invalid_index, invalid_index, 0.});
  const std::vector<Point<2>> polygon = regular_polygon(n_sides);
  const double length_of_half = std::sin(dealii::numbers::PI / n_sides);
  dealii::FEFaceValues<2> on_face(
      element, dealii::QGauss<1>(element.dofs_per_face),
      dealii::update_values | dealii::update_normal_vectors |
          dealii::update_JxW_values);
  for (const auto &cell : dof_handler.active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
    {
      if (!cell->face(face)->at_boundary())
        continue;
      on_face.reinit(cell, face);
      const dealii::Vector<double> coefficients = even_flux(on_face, face);
      const unsigned int sub_cell = cell->active_cell_index();
      const unsigned int side = sub_cell / cut.of_triangle().size();
      const Point<2> middle = cell->face(face)->center();
      const unsigned int half =
          middle.distance(polygon[side]) <
                  middle.distance(polygon[(side + 1) % n_sides])
              ? 2 * side
              : 2 * side + 1;
      const double share = cell->face(face)->measure() / length_of_half;
      for (unsigned int f = 0; f < coefficients.size(); ++f)
        fluxes[sub_cell * element.dofs_per_cell +
               element.face_to_cell_index(f, face)] = {invalid_index, half,
                                                       share * coefficients[f]};
    }
}

/**
 * Number the fluxes that are not prescribed. By deal.II's numbers a flux
 * through a line between two sub-cells is recognised from its other side.
 */
void CellSpaces::number_fluxes(const dealii::DoFHandler<2> &dof_handler)
{
  std::vector<unsigned int> unknown(dof_handler.n_dofs(), invalid_index);
  std::vector<dealii::types::global_dof_index> indices(element.dofs_per_cell);
  for (const auto &cell : dof_handler.active_cell_iterators())
  {
    cell->get_dof_indices(indices);
    for (unsigned int k = 0; k < element.dofs_per_cell; ++k)
    {
      Flux &flux =
          fluxes[cell->active_cell_index() * element.dofs_per_cell + k];
      if (flux.half != invalid_index)
        continue;
      if (unknown[indices[k]] == invalid_index)
        unknown[indices[k]] = unknown_fluxes++;
      flux.unknown = unknown[indices[k]];
    }
  }
}

/**
 * The basis functions of neighbours must agree on the direction of a common
 * flux: deal.II turns those of one of them around. Seen on the regular polygon,
 * by the side.
 */
void CellSpaces::find_orientations(const dealii::DoFHandler<2> &dof_handler,
                                   const unsigned int n_sides)
{
  orientations.assign(n_sub_cells() * element.dofs_per_cell, 1.);
  place(regular_polygon(n_sides), false);
  dealii::FEValues<2> inside(element, gauss, dealii::update_values);
  const dealii::FEValuesExtractors::Vector row(0);
  for (const auto &cell : dof_handler.active_cell_iterators())
  {
    const unsigned int s = cell->active_cell_index();
    inside.reinit(cell);
    for (unsigned int k = 0; k < element.dofs_per_cell; ++k)
    {
      double product = 0.;
      for (unsigned int q = 0; q < gauss.size(); ++q)
        product += integrals(s).at_points(q, k) * inside[row].value(k, q);
      if (product < 0.)
        orientations[s * element.dofs_per_cell + k] = -1.;
    }
  }
}

void CellSpaces::place(const std::vector<Point<2>> &vertices,
                       const bool with_flux_mass)
{
  const unsigned int per_side = cut.of_triangle().size();
  for (unsigned int s = 0; s < n_sub_cells(); ++s)
  {
    const unsigned int i = s / per_side;
    const auto corners = cut.corners(s % per_side, {}, vertices[i],
                                     vertices[(i + 1) % vertices.size()]);
    map(s, corners);
    integrate(all_integrals[s], with_flux_mass);
    for (unsigned int j = 0; j < multiplier.dofs_per_cell; ++j)
    {
      const Point<2> &node = multiplier.get_unit_support_points()[j];
      Point<2> &x = all_integrals[s].nodes[j];
      x = Point<2>();
      for (unsigned int v = 0; v < 4; ++v)
        x += dealii::GeometryInfo<2>::d_linear_shape_function(node, v) *
             corners[v];
    }
  }
}

/**
 * Carry phi_k from the reference square to a sub-cell, by the bilinear map F
 * and Piola's transform DF phi / det DF. FEValues would do the same in four
 * times the time or more, and the time of a cell of Fan would grow by a third.
 */
void CellSpaces::map(const unsigned int sub_cell,
                     const std::array<Point<2>, 4> &corners)
{
  Integrals &result = all_integrals[sub_cell];
  const unsigned int n_fluxes = element.dofs_per_cell;
  const double *const orientation = &orientations[sub_cell * n_fluxes];
  for (unsigned int q = 0; q < points.size(); ++q)
  {
    const Point<2> &p = points.point(q);
    const Tensor<1, 2> along_x = (1. - p[1]) * (corners[1] - corners[0]) +
                                 p[1] * (corners[3] - corners[2]);
    const Tensor<1, 2> along_y = (1. - p[0]) * (corners[2] - corners[0]) +
                                 p[0] * (corners[3] - corners[1]);
    const double det = cross(along_x, along_y);
    const bool in_the_middle = q == gauss.size();
    if (!in_the_middle)
      result.weights[q] = gauss.weight(q) * det;
    for (unsigned int k = 0; k < n_fluxes; ++k)
    {
      const Tensor<1, 2> &phi = reference_values(q, k);
      Tensor<1, 2> &value =
          in_the_middle ? result.in_the_middle[k] : result.at_points(q, k);
      value = orientation[k] / det * (phi[0] * along_x + phi[1] * along_y);
    }
  }
}

void CellSpaces::integrate(Integrals &result, const bool with_flux_mass) const
{
  const unsigned int n_fluxes = element.dofs_per_cell;
  const unsigned int n_multipliers = multiplier.dofs_per_cell;
  const auto sum = [&](const auto &at_point) {
    decltype(at_point(0)) total{};
    for (unsigned int q = 0; q < gauss.size(); ++q)
      total += at_point(q);
    return total;
  };
  const auto &w = multipliers;
  const auto &weight = result.weights;
  const auto &phi = result.at_points;
  result.area = sum([&](unsigned int q) { return weight[q]; });
  for (unsigned int j = 0; j < n_multipliers; ++j)
  {
    result.mean[j] = sum([&](unsigned int q) { return w(j, q) * weight[q]; });
    for (unsigned int l = 0; l < n_multipliers; ++l)
      result.mass(j, l) =
          sum([&](unsigned int q) { return w(j, q) * w(l, q) * weight[q]; });
    for (unsigned int k = 0; k < n_fluxes; ++k)
      result.moment(j, k) = sum([&](unsigned int q) -> Tensor<1, 2> {
        return w(j, q) * weight[q] * phi(q, k);
      });
  }
  if (with_flux_mass)
    for (unsigned int k = 0; k < n_fluxes; ++k)
      for (unsigned int l = 0; l <= k; ++l)
        result.flux_mass(k, l) = result.flux_mass(l, k) =
            sum([&](unsigned int q) -> double {
              return weight[q] * (phi(q, k) * phi(q, l));
            });
}
} // namespace Voussoir
