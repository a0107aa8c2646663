// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/contacts/cell_edges.h>

#include <algorithm>
#include <tuple>

namespace Voussoir
{
namespace
{
/** The sine of an angle that is none. */
constexpr double no_angle = 1e-9;

/** A side of a face. */
struct FaceSide
{
  unsigned int begin, end, face;

  /** Equal for the two sides that an edge is. */
  std::array<unsigned int, 2> edge() const
  {
    return {{std::min(begin, end), std::max(begin, end)}};
  }
};

bool is_near(const CellFaces &cells,
             const FaceSide &side,
             const SpaceBox &box,
             const double distance)
{
  const auto &[low, high] = box.get_boundary_points();
  const dealii::Point<3> &a = cells.vertices[side.begin],
                         &b = cells.vertices[side.end];
  for (unsigned int d = 0; d < 3; ++d)
    if (std::min(a[d], b[d]) > high[d] + distance ||
        std::max(a[d], b[d]) < low[d] - distance)
      return false;
  return true;
}
} // namespace

bool CellEdge::rises(const dealii::Tensor<1, 3> &normal) const
{
  return into_face[0] * normal > no_angle && into_face[1] * normal > no_angle;
}

bool CellEdge::is_convex(const FaceGeometry &geometry) const
{
  return into_face[1] * geometry.planes[faces[0]].normal < 0.;
}

std::vector<CellEdge> edges_near(const FaceGeometry &geometry,
                                 const std::vector<unsigned int> &faces,
                                 const SpaceBox &box)
{
  const CellFaces &cells = geometry.cells;
  std::vector<FaceSide> sides;
  for (const unsigned int f : faces)
  {
    const auto corners = cells.corners(f);
    for (unsigned int i = 0; i < corners.size(); ++i)
    {
      const FaceSide side = {corners[i], corners[(i + 1) % corners.size()], f};
      if (cells.vertices[side.begin] != cells.vertices[side.end] &&
          is_near(cells, side, box, geometry.tolerance))
        sides.push_back(side);
    }
  }
  // The side that runs upwards in numbers comes first.
  std::sort(sides.begin(), sides.end(),
            [](const FaceSide &a, const FaceSide &b) {
              return std::make_tuple(a.edge(), a.begin, a.face) <
                     std::make_tuple(b.edge(), b.begin, b.face);
            });
  std::vector<CellEdge> edges;
  for (std::size_t i = 0, end; i < sides.size(); i = end)
  {
    end = i + 1;
    while (end < sides.size() && sides[end].edge() == sides[i].edge())
      ++end;
    if (end - i != 2 || sides[i].begin != sides[i + 1].end)
      continue; // more than two faces meet there
    CellEdge edge = {{{sides[i].begin, sides[i].end}},
                     {{sides[i].face, sides[i + 1].face}},
                     {}};
    dealii::Tensor<1, 3> along =
        cells.vertices[edge.ends[1]] - cells.vertices[edge.ends[0]];
    along /= along.norm();
    for (unsigned int k = 0; k < 2; ++k)
      edge.into_face[k] =
          (k == 0 ? 1. : -1.) *
          cross_product_3d(geometry.planes[edge.faces[k]].normal, along);
    edges.push_back(edge);
  }
  return edges;
}
} // namespace Voussoir
