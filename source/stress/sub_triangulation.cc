// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/stress/sub_triangulation.h>

#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>

namespace Voussoir
{
using dealii::Point;

SubTriangulation SubTriangulation::thirds(const unsigned int n_refinements)
{
  // The unit triangle, in which a point is its own pair of weights. Each line
  // has the same direction in both of its quadrilaterals, as deal.II's elements
  // need, also across the spokes: away from the centre.
  const std::vector<Point<2>> vertices = {
      {0., 0.},  {0.5, 0.},        {1., 0.},  {0., 0.5},
      {0., 1.0}, {1. / 3, 1. / 3}, {0.5, 0.5}};
  std::vector<dealii::CellData<2>> cells(3);
  cells[0].vertices = {0, 1, 3, 5};
  cells[1].vertices = {1, 2, 5, 6};
  cells[2].vertices = {3, 5, 4, 6};
  dealii::Triangulation<2> triangle;
  triangle.create_triangulation(vertices, cells, dealii::SubCellData());
  triangle.refine_global(n_refinements);

  SubTriangulation cut;
  for (const auto &cell : triangle.active_cell_iterators())
  {
    Quadrilateral corners;
    for (unsigned int v = 0; v < corners.size(); ++v)
      corners[v] = {cell->vertex(v)[0], cell->vertex(v)[1]};
    cut.quadrilaterals.push_back(corners);
  }
  return cut;
}

std::array<Point<2>, 4>
SubTriangulation::corners(const unsigned int k,
                          const Point<2> &centre,
                          const Point<2> &vertex_i,
                          const Point<2> &vertex_j) const
{
  std::array<Point<2>, 4> corners;
  for (unsigned int v = 0; v < corners.size(); ++v)
  {
    const Vertex &weights = quadrilaterals[k][v];
    corners[v] = centre + weights.a * (vertex_i - centre) +
                 weights.b * (vertex_j - centre);
  }
  return corners;
}
} // namespace Voussoir
