// SPDX-License-Identifier: LGPL-2.1-or-later

// The elements on the sub-cells of random cells against deal.II's FEValues and
// FEFaceValues on the same quadrilaterals: weights, basis functions, their
// divergences and products, the nodes of the multipliers, the normal traces on
// the sides, and which fluxes two sub-cells share.
// In Release only: an assertion of deal.II refuses the quadrilaterals of a fan,
// whose corner on a side is straight.

#include <voussoir/stress/cell_spaces.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include "tests.h"
#include <map>

namespace test_cell_spaces_fe_values
{
using namespace Voussoir;
using dealii::FEValues;
using dealii::Point;
using dealii::Tensor;

/** The largest errors of all sub-cells, see compare(). */
std::map<std::string, double> errors;

/**
 * The farthest corner of the sub-cell over its shortest edge: rounding of its
 * corners is as many times larger relative to its edges.
 */
double condition = 1.;

/**
 * The largest difference of numbers or vectors over the largest of those
 * wanted, or over @p unit if that is larger, and over the condition.
 */
template <typename T>
void compare(const std::string &what,
             const std::vector<T> &found,
             const std::vector<T> &wanted,
             const double unit = 0.)
{
  const auto size = [](const T &t) {
    if constexpr (std::is_same<T, double>::value)
      return std::abs(t);
    else
      return t.norm();
  };
  double difference = found.size() == wanted.size() ? 0. : HUGE_VAL;
  double largest = unit;
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    difference = std::max(difference, size(T(found[i] - wanted[i])));
    largest = std::max(largest, size(wanted[i]));
  }
  errors[what] = std::max(errors[what], difference / largest / condition);
}

/** The sub-cells of a cell around the origin, as deal.II has them. */
void cut_into_quadrilaterals(dealii::Triangulation<2> &triangulation,
                             const SubTriangulation &cut,
                             const std::vector<Point<2>> &polygon)
{
  std::vector<Point<2>> vertices;
  std::vector<dealii::CellData<2>> cells;
  for (unsigned int i = 0; i < polygon.size(); ++i)
    for (unsigned int k = 0; k < cut.of_triangle().size(); ++k)
    {
      cells.emplace_back();
      for (unsigned int v = 0; v < 4; ++v)
      {
        cells.back().vertices[v] = vertices.size();
        vertices.push_back(cut.corners(k, {}, polygon[i],
                                       polygon[(i + 1) % polygon.size()])[v]);
      }
    }
  dealii::SubCellData no_sides;
  std::vector<unsigned int> all;
  dealii::GridTools::delete_duplicated_vertices(vertices, cells, no_sides, all,
                                                1e-12);
  triangulation.create_triangulation(vertices, cells, no_sides);
}

/** Spaces, and deal.II's of the same degree. */
struct Spaces
{
  Spaces(const SubTriangulation &cut,
         const unsigned int n_sides,
         const unsigned int degree)
      : cut(cut), spaces(cut, n_sides, degree), element(degree),
        multiplier(degree), gauss(degree + 2), on_line(degree + 2)
  {}

  void compare_with_fe_values(const std::vector<Point<2>> &polygon);

private:
  void compare_integrals(const CellSpaces::Integrals &integrals,
                         const FEValues<2> &w,
                         const FEValues<2> &phi);
  void compare_divergences(unsigned int s,
                           const FEValues<2> &w,
                           const FEValues<2> &phi);
  void compare_traces(const dealii::DoFHandler<2>::active_cell_iterator &cell,
                      const std::vector<Point<2>> &polygon);
  void compare_numbers(const dealii::DoFHandler<2> &dof_handler);

  const SubTriangulation cut;
  CellSpaces spaces;
  const dealii::FE_RaviartThomas<2> element;
  const dealii::FE_DGQ<2> multiplier;
  const dealii::QGauss<2> gauss;
  const dealii::QGauss<1> on_line;
  const dealii::FEValuesExtractors::Vector row{0};
};

void Spaces::compare_with_fe_values(const std::vector<Point<2>> &polygon)
{
  spaces.place(polygon, true);
  dealii::Triangulation<2> triangulation;
  cut_into_quadrilaterals(triangulation, cut, polygon);
  dealii::DoFHandler<2> dof_handler(triangulation);
  dof_handler.distribute_dofs(element);
  const auto flags = dealii::update_values | dealii::update_gradients |
                     dealii::update_JxW_values |
                     dealii::update_quadrature_points;
  FEValues<2> phi(element, gauss, flags), w(multiplier, gauss, flags);
  const dealii::Quadrature<2> middle(Point<2>(0.5, 0.5)),
      nodes(multiplier.get_unit_support_points());
  FEValues<2> in_the_middle(element, middle, flags);
  FEValues<2> at_nodes(multiplier, nodes, flags);
  for (const auto &cell : dof_handler.active_cell_iterators())
  {
    const CellSpaces::Integrals &integrals =
        spaces.integrals(cell->active_cell_index());
    double farthest = 0., shortest = HUGE_VAL;
    for (unsigned int i = 0; i < 4; ++i)
    {
      farthest = std::max(farthest, cell->vertex(i).norm());
      shortest = std::min(shortest, cell->face(i)->measure());
    }
    condition = farthest / shortest;
    phi.reinit(cell);
    const typename dealii::Triangulation<2>::cell_iterator quadrilateral = cell;
    w.reinit(quadrilateral);
    compare_integrals(integrals, w, phi);
    compare_divergences(cell->active_cell_index(), w, phi);
    compare_traces(cell, polygon);

    in_the_middle.reinit(cell);
    std::vector<Tensor<1, 2>> middle;
    for (unsigned int k = 0; k < element.dofs_per_cell; ++k)
      middle.push_back(in_the_middle[row].value(k, 0));
    compare("in the middle", integrals.in_the_middle, middle);
    at_nodes.reinit(quadrilateral);
    compare("nodes", integrals.nodes, at_nodes.get_quadrature_points());
  }
  compare_numbers(dof_handler);
}

void Spaces::compare_integrals(const CellSpaces::Integrals &integrals,
                               const FEValues<2> &w,
                               const FEValues<2> &phi)
{
  std::vector<double> mean, mass, mass_found, product, product_found;
  std::vector<Tensor<1, 2>> moment, moment_found, value, value_found;
  const auto integral = [&](const auto &f) {
    auto sum = 0. * f(0);
    for (unsigned int q = 0; q < gauss.size(); ++q)
      sum += phi.JxW(q) * f(q);
    return sum;
  };
  for (const unsigned int j : w.dof_indices())
  {
    mean.push_back(integral([&](const auto q) { return w.shape_value(j, q); }));
    for (const unsigned int l : w.dof_indices())
    {
      mass.push_back(integral([&](const auto q) {
        return w.shape_value(j, q) * w.shape_value(l, q);
      }));
      mass_found.push_back(integrals.mass(j, l));
    }
    for (const unsigned int k : phi.dof_indices())
    {
      moment.push_back(integral([&](const auto q) {
        return w.shape_value(j, q) * phi[row].value(k, q);
      }));
      moment_found.push_back(integrals.moment(j, k));
    }
  }
  for (const unsigned int k : phi.dof_indices())
  {
    for (unsigned int q = 0; q < gauss.size(); ++q)
    {
      value.push_back(phi[row].value(k, q));
      value_found.push_back(integrals.at_points(q, k));
    }
    for (const unsigned int l : phi.dof_indices())
    {
      product.push_back(integral([&](const auto q) {
        return phi[row].value(k, q) * phi[row].value(l, q);
      }));
      product_found.push_back(integrals.flux_mass(k, l));
    }
  }
  compare("weights", integrals.weights, phi.get_JxW_values());
  compare<double>("area", {integrals.area},
                  {integral([](unsigned int) { return 1.; })});
  compare("values", value_found, value);
  compare("w", integrals.mean, mean);
  compare("w w", mass_found, mass);
  compare("w phi", moment_found, moment);
  compare("phi phi", product_found, product);
}

void Spaces::compare_divergences(const unsigned int s,
                                 const FEValues<2> &w,
                                 const FEValues<2> &phi)
{
  std::vector<double> found, wanted;
  double of_gradient = 0.; // whose parts cancel in the divergence
  for (const unsigned int j : w.dof_indices())
    for (const unsigned int k : phi.dof_indices())
    {
      double integral = 0., size = 0.;
      for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        const double weight = w.shape_value(j, q) * phi.JxW(q);
        integral += weight * phi[row].divergence(k, q);
        size += std::abs(weight) * phi[row].gradient(k, q).norm();
      }
      found.push_back(spaces.divergence(s, j, k));
      wanted.push_back(integral);
      of_gradient = std::max(of_gradient, size);
    }
  compare("w div phi", found, wanted, of_gradient);
}

/**
 * The fluxes prescribed on a half of a side of the cell are even on it, one
 * over its length for a unit force, and those of others nothing.
 */
void Spaces::compare_traces(
    const dealii::DoFHandler<2>::active_cell_iterator &cell,
    const std::vector<Point<2>> &polygon)
{
  dealii::FEFaceValues<2> on_face(element, on_line,
                                  dealii::update_values |
                                      dealii::update_normal_vectors |
                                      dealii::update_JxW_values);
  const unsigned int s = cell->active_cell_index();
  const unsigned int side = s / cut.of_triangle().size();
  const Point<2> &start = polygon[side];
  const Point<2> &end = polygon[(side + 1) % polygon.size()];
  const double length = 0.5 * start.distance(end);
  for (const unsigned int face : cell->face_indices())
  {
    on_face.reinit(cell, face);
    const Point<2> middle = cell->face(face)->center();
    const unsigned int half =
        2 * side + (middle.distance(end) < middle.distance(start));
    std::vector<double> found(on_line.size(), 0.), lengths;
    for (unsigned int q = 0; q < on_line.size(); ++q)
      for (const unsigned int k : on_face.dof_indices())
        if (spaces.flux(s, k).unknown == dealii::numbers::invalid_unsigned_int)
          found[q] += length * spaces.flux(s, k).per_force *
                      (on_face[row].value(k, q) * on_face.normal_vector(q));
    compare(
        "normal traces", found,
        std::vector<double>(found.size(), cell->at_boundary(face) ? 1. : 0.),
        1.);
    if (cell->at_boundary(face))
      for (unsigned int f = 0; f < element.dofs_per_face; ++f)
      {
        const unsigned int k = element.face_to_cell_index(f, face);
        errors["halves of sides"] += (spaces.flux(s, k).half != half);
      }
  }
}

/** A flux is one unknown where it is one of deal.II's degrees of freedom. */
void Spaces::compare_numbers(const dealii::DoFHandler<2> &dof_handler)
{
  std::map<unsigned int, unsigned int> of_unknown, of_degree;
  std::vector<dealii::types::global_dof_index> numbers(element.dofs_per_cell);
  for (const auto &cell : dof_handler.active_cell_iterators())
  {
    cell->get_dof_indices(numbers);
    for (unsigned int k = 0; k < element.dofs_per_cell; ++k)
    {
      const unsigned int unknown =
          spaces.flux(cell->active_cell_index(), k).unknown;
      if (unknown == dealii::numbers::invalid_unsigned_int)
        continue;
      const unsigned int degree = numbers[k];
      errors["numbers"] +=
          (of_unknown.emplace(unknown, degree).first->second != degree);
      errors["numbers"] +=
          (of_degree.emplace(degree, unknown).first->second != unknown);
    }
  }
  errors["numbers"] += (of_unknown.size() != spaces.n_unknown_fluxes());
}

void run()
{
  const Packing<2> packing = random_packing(60, 1);
  for (const bool is_fan : {true, false})
    for (const unsigned int degree : {0U, 1U, 2U})
    {
      const SubTriangulation cut =
          is_fan ? SubTriangulation::fan() : SubTriangulation::thirds(1);
      std::cout << (is_fan ? "fan" : "thirds") << ", degree " << degree
                << std::endl;
      errors.clear();
      std::map<unsigned int, std::unique_ptr<Spaces>> by_sides;
      for (unsigned int c = 0; c < packing.n_cells(); ++c)
      {
        std::vector<Point<2>> polygon;
        for (unsigned int i = 0; i < packing.n_sides(c); ++i)
          polygon.emplace_back(packing.vertex(c, i) - packing.centre(c));
        auto &spaces = by_sides[polygon.size()];
        if (!spaces)
          spaces = std::make_unique<Spaces>(cut, polygon.size(), degree);
        spaces->compare_with_fe_values(polygon);
      }
      for (const auto &[what, error] : errors)
        check_error("  " + what, error, 1e-14);
    }
}

const RoomTest test("cell_spaces_fe_values", run);
} // namespace test_cell_spaces_fe_values
