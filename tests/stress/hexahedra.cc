// SPDX-License-Identifier: LGPL-2.1-or-later

// What deal.II's lowest Raviart-Thomas element on hexahedra keeps of a uniform
// field: hexahedra between a vertex, the middles of its edges and faces, and
// the centroid, as the plane's quadrilaterals. In per cent of the field, in the
// root of the mean square: the best that is left in each hexahedron, and the
// field that has the right flux through each of its faces. Quadrilaterals keep
// it.

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_raviart_thomas.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include "../statics/space_scenes.h"
#include <map>
#include <set>

namespace test_hexahedra
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** What is lost of a field, squared and integrated, and the field. */
struct Loss
{
  double best = 0., of_fluxes = 0., all = 0.;
};

/** One cell of deal.II. */
template <int dim>
void add(const std::vector<Point<dim>> &vertices, Loss &loss)
{
  dealii::Triangulation<dim> tria;
  std::vector<dealii::CellData<dim>> cells(1);
  for (unsigned int v = 0; v < vertices.size(); ++v)
    cells[0].vertices[v] = v;
  tria.create_triangulation(vertices, cells, dealii::SubCellData());
  const dealii::FE_RaviartThomas<dim> element(0);
  const dealii::MappingQ1<dim> mapping;
  const dealii::QGauss<dim> inside(4);
  const dealii::QGauss<dim - 1> on_face(3);
  dealii::FEValues<dim> values(mapping, element, inside,
                               dealii::update_values |
                                   dealii::update_JxW_values);
  dealii::FEFaceValues<dim> of_face(mapping, element, on_face,
                                    dealii::update_values |
                                        dealii::update_normal_vectors |
                                        dealii::update_JxW_values);
  values.reinit(tria.begin_active());
  const dealii::FEValuesExtractors::Vector row(0);
  const unsigned int n = element.n_dofs_per_cell();
  dealii::FullMatrix<double> mass(n, n), fluxes(n, n);
  for (unsigned int q = 0; q < inside.size(); ++q)
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        mass(i, j) +=
            values.JxW(q) * (values[row].value(i, q) * values[row].value(j, q));
  std::vector<Tensor<1, dim>> area(n);
  for (unsigned int f = 0; f < n; ++f)
  {
    of_face.reinit(tria.begin_active(), f);
    for (unsigned int q = 0; q < on_face.size(); ++q)
    {
      area[f] += of_face.JxW(q) * of_face.normal_vector(q);
      for (unsigned int i = 0; i < n; ++i)
        fluxes(f, i) += of_face.JxW(q) *
                        (of_face[row].value(i, q) * of_face.normal_vector(q));
    }
  }
  dealii::FullMatrix<double> mass_inverse(n, n), flux_inverse(n, n);
  mass_inverse.invert(mass);
  flux_inverse.invert(fluxes);
  for (unsigned int d = 0; d < dim; ++d)
  {
    dealii::Vector<double> right(n), through(n), best(n), of_fluxes(n);
    for (unsigned int i = 0; i < n; ++i)
    {
      through[i] = area[i][d];
      for (unsigned int q = 0; q < inside.size(); ++q)
        right[i] += values.JxW(q) * values[row].value(i, q)[d];
    }
    mass_inverse.vmult(best, right);
    flux_inverse.vmult(of_fluxes, through);
    for (unsigned int q = 0; q < inside.size(); ++q)
    {
      Tensor<1, dim> a, b;
      a[d] = b[d] = 1.;
      for (unsigned int i = 0; i < n; ++i)
      {
        a -= best[i] * values[row].value(i, q);
        b -= of_fluxes[i] * values[row].value(i, q);
      }
      loss.best += values.JxW(q) * a.norm_square();
      loss.of_fluxes += values.JxW(q) * b.norm_square();
      loss.all += values.JxW(q);
    }
  }
}

Point<3> middle(const std::vector<Point<3>> &points)
{
  Point<3> sum;
  for (const Point<3> &x : points)
    sum += Tensor<1, 3>(x) / static_cast<double>(points.size());
  return sum;
}

/** The hexahedra of a cell of which three faces meet in each vertex. */
void add_hexahedra(const Packing<3> &packing, const unsigned int c, Loss &loss)
{
  const CellFaces &cells = packing.polyhedra();
  std::map<unsigned int, std::vector<unsigned int>> faces_of;
  std::map<unsigned int, std::map<unsigned int, std::set<unsigned int>>>
      of_edge;
  for (unsigned int f = cells.first_face[c]; f < cells.first_face[c + 1]; ++f)
  {
    const auto corners = cells.corners(f);
    for (unsigned int k = 0; k < corners.size(); ++k)
    {
      const unsigned int a = corners[k], b = corners[(k + 1) % corners.size()];
      faces_of[a].push_back(f);
      of_edge[a][b].insert(f);
      of_edge[b][a].insert(f);
    }
  }
  const auto middle_of_face = [&](const unsigned int f) {
    std::vector<Point<3>> points;
    for (const unsigned int v : cells.corners(f))
      points.push_back(cells.vertices[v]);
    return middle(points);
  };
  for (const auto &[v, faces] : faces_of)
  {
    const Point<3> &x = cells.vertices[v];
    std::vector<unsigned int> ends;
    for (const auto &[end, of] : of_edge[v])
      ends.push_back(end);
    if (ends.size() != 3)
      continue;
    const auto arm = [&](const unsigned int k) {
      return cells.vertices[ends[k]] - x;
    };
    if (cross_product_3d(arm(0), arm(1)) * arm(2) < 0.)
      std::swap(ends[1], ends[2]);
    const auto of_edges = [&](const unsigned int i, const unsigned int j) {
      for (const unsigned int f : of_edge[v][ends[i]])
        if (of_edge[v][ends[j]].count(f) > 0)
          return middle_of_face(f);
      return x;
    };
    add<3>({x, x + 0.5 * arm(0), x + 0.5 * arm(1), of_edges(0, 1),
            x + 0.5 * arm(2), of_edges(0, 2), of_edges(1, 2),
            packing.moments(c).centroid},
           loss);
  }
}

void report(const std::string &name, const Loss &loss)
{
  std::cout << name << ": "
            << std::lround(100. * std::sqrt(loss.best / loss.all)) << ", "
            << std::lround(100. * std::sqrt(loss.of_fluxes / loss.all))
            << std::endl;
}

void run()
{
  Random random(1);
  Loss of_plane;
  for (unsigned int k = 0; k < 100; ++k)
    add<2>({{0.3 * random(), 0.3 * random()},
            {1. - 0.3 * random(), 0.3 * random()},
            {0.3 * random(), 1. - 0.3 * random()},
            {1. - 0.3 * random(), 1. - 0.3 * random()}},
           of_plane);
  check_error("Quadrilaterals, best", std::sqrt(of_plane.best), 1e-12);
  check_error("  by fluxes", std::sqrt(of_plane.of_fluxes), 1e-12);

  Loss of_cube;
  CellFaces cube;
  add_box(cube, {0., 0., 0.}, {1., 2., 3.});
  add_hexahedra(Packing<3>(cube), 0, of_cube);
  check_error("Boxes, best", std::sqrt(of_cube.best), 1e-12);
  check_error("  by fluxes", std::sqrt(of_cube.of_fluxes), 1e-12);

  CellFaces simplex;
  simplex.vertices = {
      {1., 1., 1.}, {1., -1., -1.}, {-1., 1., -1.}, {-1., -1., 1.}};
  for (const std::vector<unsigned int> &face :
       {std::vector<unsigned int>{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})
    simplex.add_face(face);
  simplex.end_cell();
  Loss of_simplex;
  add_hexahedra(Packing<3>(simplex), 0, of_simplex);
  report("Lost in a regular tetrahedron, per cent, best and by fluxes",
         of_simplex);

  const Packing<3> grains = cells_in_box(200, {1., 1., 1.}, 3);
  Loss of_grains;
  for (unsigned int c = 0; c < grains.n_cells(); ++c)
    add_hexahedra(grains, c, of_grains);
  report("Lost in random cells", of_grains);
}

const RoomTest test("hexahedra", run);
} // namespace test_hexahedra
