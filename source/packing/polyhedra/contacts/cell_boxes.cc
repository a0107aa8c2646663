// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/contacts/cell_boxes.h>

#include <deal.II/boost_adaptors/bounding_box.h>
#include <deal.II/boost_adaptors/point.h>

#include <boost/function_output_iterator.hpp>
#include <boost/geometry.hpp>

#include <algorithm>
#include <limits>

namespace Voussoir
{
namespace
{
using dealii::Point;

/** The boxes around all faces. */
std::vector<SpaceBox> boxes_of_faces(const CellFaces &cells)
{
  std::vector<SpaceBox> boxes;
  boxes.reserve(cells.n_faces());
  for (unsigned int f = 0; f < cells.n_faces(); ++f)
  {
    const auto corners = cells.corners(f);
    if (corners.size() == 0)
    {
      boxes.emplace_back();
      continue;
    }
    Point<3> low = cells.vertices[corners[0]], high = low;
    for (const unsigned int v : corners)
      for (unsigned int d = 0; d < 3; ++d)
      {
        low[d] = std::min(low[d], cells.vertices[v][d]);
        high[d] = std::max(high[d], cells.vertices[v][d]);
      }
    boxes.push_back(SpaceBox({low, high}));
  }
  return boxes;
}

/** The boxes around all cells. */
std::vector<SpaceBox> boxes_of_cells(const CellFaces &cells,
                                     const std::vector<SpaceBox> &faces)
{
  std::vector<SpaceBox> boxes;
  boxes.reserve(cells.n_cells());
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
  {
    const unsigned int begin = cells.first_face[c];
    boxes.push_back(begin < cells.first_face[c + 1] ? faces[begin]
                                                    : SpaceBox());
    for (unsigned int f = begin; f < cells.first_face[c + 1]; ++f)
      boxes.back().merge_with(faces[f]);
  }
  return boxes;
}
} // namespace

double common_extent(const SpaceBox &one, const SpaceBox &other)
{
  const auto &[low_one, high_one] = one.get_boundary_points();
  const auto &[low_other, high_other] = other.get_boundary_points();
  double least = std::numeric_limits<double>::max();
  for (unsigned int d = 0; d < 3; ++d)
    least = std::min(least, std::min(high_one[d], high_other[d]) -
                                std::max(low_one[d], low_other[d]));
  return least;
}

CellBoxes::CellBoxes(const CellFaces &cells)
    : faces(boxes_of_faces(cells)), boxes(boxes_of_cells(cells, faces)),
      tree(dealii::pack_rtree_of_indices(boxes))
{}

std::vector<unsigned int> CellBoxes::touching(const SpaceBox &box) const
{
  std::vector<unsigned int> found;
  tree.query(boost::geometry::index::intersects(box),
             std::back_inserter(found));
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<unsigned int>
CellBoxes::higher_neighbours(const unsigned int cell,
                             const double distance) const
{
  SpaceBox box = boxes[cell];
  box.extend(distance);
  std::vector<unsigned int> found;
  tree.query(boost::geometry::index::intersects(box),
             boost::make_function_output_iterator([&](const std::size_t c) {
               if (c > cell)
                 found.push_back(c);
             }));
  std::sort(found.begin(), found.end());
  return found;
}
} // namespace Voussoir
