// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/contacts/convex_cells.h>

#include <algorithm>
#include <limits>

namespace Voussoir
{
namespace
{
using dealii::Point;
using dealii::Tensor;

/** The sine of the angle of edges that have no common normal, by rounding. */
constexpr double sine_of_parallel_edges = 1e-12;

/** The part of a polygon below a plane. */
std::vector<Point<3>> part_below(const std::vector<Point<3>> &polygon,
                                 const Tensor<1, 3> &normal,
                                 const Point<3> &in_plane)
{
  std::vector<Point<3>> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point<3> &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at_p = normal * (p - in_plane), at_q = normal * (q - in_plane);
    if (at_p <= 0.)
      kept.push_back(p);
    if ((at_p < 0. && at_q > 0.) || (at_p > 0. && at_q < 0.))
      kept.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return kept;
}
} // namespace

ConvexCells::ConvexCells(const FaceGeometry &geometry)
    : geometry(geometry), reach(geometry.cells.n_faces(), 0.)
{
  const CellFaces &cells = geometry.cells;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
  {
    const unsigned int begin = cells.first_corner[cells.first_face[c]];
    const unsigned int end = cells.first_corner[cells.first_face[c + 1]];
    vertices.insert(vertices.end(), cells.loops.begin() + begin,
                    cells.loops.begin() + end);
    const auto of_cell = vertices.begin() + first_vertex.back();
    std::sort(of_cell, vertices.end());
    vertices.erase(std::unique(of_cell, vertices.end()), vertices.end());
    first_vertex.push_back(vertices.size());
    bool is_convex = true;
    for (unsigned int f = cells.first_face[c]; f < cells.first_face[c + 1]; ++f)
    {
      const FacePlane &plane = geometry.planes[f];
      for (const unsigned int v : vertices_of(c))
        reach[f] = std::max(reach[f],
                            plane.normal * (cells.vertices[v] - plane.centre));
      if (has_width(f) && reach[f] > geometry.tolerance)
        is_convex = false;
    }
    convex.push_back(is_convex);
  }
}

dealii::ArrayView<const unsigned int>
ConvexCells::vertices_of(const unsigned int cell) const
{
  return {vertices.data() + first_vertex[cell],
          first_vertex[cell + 1] - first_vertex[cell]};
}

bool ConvexCells::has_width(const unsigned int face) const
{
  return geometry.pieces.first_of_face(face) <
         geometry.pieces.first_of_face(face + 1);
}

double ConvexCells::overlap_depth(const unsigned int one,
                                  const unsigned int other,
                                  const double enough) const
{
  double depth = least_over_faces(one, other, enough);
  if (depth > enough)
    depth = std::min(depth, least_over_faces(other, one, enough));
  if (depth > enough)
    depth = std::min(depth, least_over_edges(one, other, enough));
  return depth;
}

double ConvexCells::least_over_faces(const unsigned int one,
                                     const unsigned int other,
                                     const double enough) const
{
  double least = std::numeric_limits<double>::max();
  for (unsigned int f = geometry.cells.first_face[one];
       f < geometry.cells.first_face[one + 1] && least > enough; ++f)
  {
    if (!has_width(f))
      continue;
    const FacePlane &plane = geometry.planes[f];
    double lowest = std::numeric_limits<double>::max();
    for (const unsigned int v : vertices_of(other))
      lowest = std::min(
          lowest, plane.normal * (geometry.cells.vertices[v] - plane.centre));
    least = std::min(least, reach[f] - lowest);
  }
  return least;
}

std::vector<Tensor<1, 3>> ConvexCells::edges_of(const unsigned int cell) const
{
  const CellFaces &cells = geometry.cells;
  std::vector<Tensor<1, 3>> edges;
  for (unsigned int f = cells.first_face[cell]; f < cells.first_face[cell + 1];
       ++f)
  {
    const auto corners = cells.corners(f);
    for (unsigned int i = 0; i < corners.size(); ++i)
    {
      // Each edge is there in both directions.
      const unsigned int v = corners[i], w = corners[(i + 1) % corners.size()];
      if (v < w)
        edges.push_back(cells.vertices[w] - cells.vertices[v]);
    }
  }
  return edges;
}

double ConvexCells::least_over_edges(const unsigned int one,
                                     const unsigned int other,
                                     const double enough) const
{
  double least = std::numeric_limits<double>::max();
  const std::vector<Tensor<1, 3>> theirs = edges_of(other);
  for (const Tensor<1, 3> &edge : edges_of(one))
    for (const Tensor<1, 3> &their : theirs)
    {
      const Tensor<1, 3> axis = cross_product_3d(edge, their);
      const double length = axis.norm();
      if (!(length > sine_of_parallel_edges * edge.norm() * their.norm()))
        continue;
      least = std::min(least, overlap_along(axis / length, one, other));
      if (!(least > enough))
        return least;
    }
  return least;
}

double ConvexCells::overlap_along(const Tensor<1, 3> &axis,
                                  const unsigned int one,
                                  const unsigned int other) const
{
  constexpr double largest = std::numeric_limits<double>::max();
  const Point<3> &origin =
      geometry.cells.vertex(geometry.cells.first_face[one], 0);
  std::array<double, 2> low = {{largest, largest}};
  std::array<double, 2> high = {{-largest, -largest}};
  for (unsigned int k = 0; k < 2; ++k)
    for (const unsigned int v : vertices_of(k == 0 ? one : other))
    {
      const double at = axis * (geometry.cells.vertices[v] - origin);
      low[k] = std::min(low[k], at);
      high[k] = std::max(high[k], at);
    }
  return std::min(high[0] - low[1], high[1] - low[0]);
}

Point<3> ConvexCells::common_place(const unsigned int one,
                                   const unsigned int other) const
{
  std::vector<Point<3>> corners = corners_inside(one, other);
  const std::vector<Point<3>> theirs = corners_inside(other, one);
  corners.insert(corners.end(), theirs.begin(), theirs.end());
  const Point<3> origin =
      corners.empty() ? geometry.boxes.of_cell(one).center() : corners.front();
  Tensor<1, 3> sum;
  for (const Point<3> &corner : corners)
    sum += corner - origin;
  return origin + sum / std::max<double>(corners.size(), 1.);
}

std::vector<Point<3>>
ConvexCells::corners_inside(const unsigned int one,
                            const unsigned int other) const
{
  const CellFaces &cells = geometry.cells;
  std::vector<Point<3>> corners;
  for (unsigned int f = cells.first_face[one]; f < cells.first_face[one + 1];
       ++f)
  {
    std::vector<Point<3>> polygon = cells.polygon(f);
    for (unsigned int g = cells.first_face[other];
         g < cells.first_face[other + 1]; ++g)
      if (has_width(g))
        polygon = part_below(polygon, geometry.planes[g].normal,
                             geometry.planes[g].centre);
    corners.insert(corners.end(), polygon.begin(), polygon.end());
  }
  return corners;
}
} // namespace Voussoir
