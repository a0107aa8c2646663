// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/cell_moments.h>
#include <voussoir/packing/polyhedra/generators/block_builder.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <utility>

namespace Voussoir
{
using dealii::Point;

namespace
{
constexpr unsigned int corners_of_box = 8;

/** The faces of a box, whose corners are numbered as deal.II does. */
constexpr std::array<std::array<unsigned int, 4>, 6> faces_of_box = {
    {{{0, 4, 6, 2}},
     {{1, 3, 7, 5}},
     {{0, 1, 5, 4}},
     {{2, 6, 7, 3}},
     {{0, 2, 3, 1}},
     {{4, 5, 7, 6}}}};
/**
 * The distance at which faces of blocks touch, over the largest extent of all:
 * more than rounding in a few operations, less than any measure of a block.
 */
constexpr double tolerance_of_blocks = 1e-9;

/** The largest extent along an axis of points, if there are any; a length. */
double largest_extent(const BlockBuilder::Loop &points)
{
  double extent = 0.;
  for (unsigned int d = 0; d < 3 && !points.empty(); ++d)
  {
    const auto [low, high] = std::minmax_element(
        points.begin(), points.end(),
        [&](const Point<3> &a, const Point<3> &b) { return a[d] < b[d]; });
    extent = std::max(extent, (*high)[d] - (*low)[d]);
  }
  return extent;
}
} // namespace

BlockBuilder::BlockBuilder(std::vector<std::string> group_names)
{
  cells.group_names = std::move(group_names);
}

void BlockBuilder::reserve_boxes(const unsigned int n_boxes)
{
  const std::size_t n_faces = std::size_t(n_boxes) * faces_of_box.size();
  cells.vertices.reserve(std::size_t(n_boxes) * corners_of_box);
  cells.loops.reserve(n_faces * faces_of_box[0].size());
  cells.first_corner.reserve(n_faces + 1);
  cells.first_face.reserve(n_boxes + 1);
  cells.group.reserve(n_boxes);
}

void BlockBuilder::add_box(const Point<3> &low,
                           const Point<3> &high,
                           const unsigned int group)
{
  std::array<Point<3>, corners_of_box> corners;
  for (unsigned int i = 0; i < corners_of_box; ++i)
    for (unsigned int d = 0; d < 3; ++d)
      corners[i][d] = (i >> d & 1) != 0 ? high[d] : low[d];
  add_hexahedron(corners, group);
}

void BlockBuilder::add_frustum(const Loop &lower,
                               const Loop &upper,
                               const unsigned int group)
{
  const unsigned int n = lower.size();
  Assert(n >= 3 && upper.size() == n,
         dealii::ExcMessage("A frustum has two sections alike."));
  const unsigned int first = cells.vertices.size();
  cells.vertices.insert(cells.vertices.end(), lower.begin(), lower.end());
  cells.vertices.insert(cells.vertices.end(), upper.begin(), upper.end());
  std::vector<unsigned int> bottom(n), top(n);
  for (unsigned int i = 0; i < n; ++i)
  {
    bottom[i] = first + n - 1 - i;
    top[i] = first + n + i;
  }
  cells.add_face(bottom);
  cells.add_face(top);
  for (unsigned int i = 0; i < n; ++i)
  {
    const unsigned int next = (i + 1) % n;
    cells.add_face(std::array<unsigned int, 4>{
        {first + i, first + next, first + n + next, first + n + i}});
  }
  finish_block(group);
}

void BlockBuilder::add_hexahedron(const std::array<Point<3>, 8> &corners,
                                  const unsigned int group)
{
  const unsigned int first = cells.vertices.size();
  cells.vertices.insert(cells.vertices.end(), corners.begin(), corners.end());
  for (std::array<unsigned int, 4> face : faces_of_box)
  {
    for (unsigned int &vertex : face)
      vertex += first;
    cells.add_face(face);
  }
  finish_block(group);
}

void BlockBuilder::add_polyhedron(
    const Loop &vertices,
    const std::vector<std::vector<unsigned int>> &faces,
    const unsigned int group)
{
  const unsigned int first = cells.vertices.size();
  cells.vertices.insert(cells.vertices.end(), vertices.begin(), vertices.end());
  for (std::vector<unsigned int> face : faces)
  {
    for (unsigned int &vertex : face)
    {
      AssertIndexRange(vertex, vertices.size());
      vertex += first;
    }
    cells.add_face(face);
  }
  finish_block(group);
}

CellFaces BlockBuilder::take()
{
  cells.tolerance = tolerance_of_blocks * largest_extent(cells.vertices);
  return std::exchange(cells, CellFaces());
}

void BlockBuilder::finish_block(const unsigned int group)
{
  AssertIndexRange(group, cells.group_names.size());
  cells.end_cell();
  cells.group.push_back(group);
  const unsigned int cell = cells.n_cells() - 1;
  if (moments_of(cells, cell).volume >= 0.)
    return;
  for (unsigned int f = cells.first_face[cell]; f < cells.n_faces(); ++f)
    std::reverse(cells.loops.begin() + cells.first_corner[f],
                 cells.loops.begin() + cells.first_corner[f + 1]);
}
} // namespace Voussoir
