// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_sub_triangulation_h
#define voussoir_stress_sub_triangulation_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace Voussoir
{
/**
 * The cut of a cell into quadrilaterals, its sub-cells: each triangle of the
 * cell's centre and one side is cut in the same way. Vertices lie at centre + a
 * (v_i - centre) + b (v_j - centre) in the triangle of the side from v_i to v_j
 * = v_{i+1}.
 */
class SubTriangulation
{
public:
  /** The weights, not negative, and together at most one. */
  struct Vertex
  {
    double a; /**< of v_i */
    double b; /**< of v_j */
  };
  /** In deal.II's (lexicographic) order. */
  using Quadrilateral = std::array<Vertex, 4>;

  /**
   * One quadrilateral a side: the triangle itself, with its side cut in two.
   * The only vertex inside the cell is its centre.
   */
  static SubTriangulation fan()
  {
    SubTriangulation cut;
    cut.quadrilaterals = {{{{0., 0.}, {1., 0.}, {0., 1.}, {0.5, 0.5}}}};
    return cut;
  }

  /**
   * Three quadrilaterals a side, between the centroid of the triangle and the
   * middles of its edges, and each of them cut in four @p n_refinements times.
   * Their shape is as good as that of the triangle.
   */
  static SubTriangulation thirds(unsigned int n_refinements);

  /** The sub-cells of a triangle. */
  const std::vector<Quadrilateral> &of_triangle() const
  {
    return quadrilaterals;
  }

  /** The corners of sub-cell @p k of a triangle. */
  std::array<dealii::Point<2>, 4>
  corners(unsigned int k,
          const dealii::Point<2> &centre,
          const dealii::Point<2> &vertex_i,
          const dealii::Point<2> &vertex_j) const;

private:
  SubTriangulation() = default;

  std::vector<Quadrilateral> quadrilaterals;
};
} // namespace Voussoir

#endif
