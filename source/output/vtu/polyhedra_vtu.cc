// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/polyhedra.h>
#include <voussoir/output/vtu/field_arrays.h>
#include <voussoir/output/vtu/polyhedra_vtu.h>
#include <voussoir/output/vtu/vtu_values.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <numeric>
#include <type_traits>

namespace Voussoir
{
namespace
{
/** The points of polyhedra, and where those of each begin. */
struct PolyhedronPoints
{
  explicit PolyhedronPoints(const CellFaces &cells);

  /** The vertex numbers of the points of one cell after the other. */
  std::vector<unsigned int> vertices;
  /** The first of each cell, and the end. */
  std::vector<std::size_t> first = {0};
  /** The first number of each cell in the list of faces, and the end. */
  std::vector<std::size_t> first_number = {0};
};

PolyhedronPoints::PolyhedronPoints(const CellFaces &cells)
{
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
  {
    const unsigned int begin = cells.first_face[c];
    const unsigned int end = cells.first_face[c + 1];
    vertices.insert(vertices.end(),
                    cells.loops.begin() + cells.first_corner[begin],
                    cells.loops.begin() + cells.first_corner[end]);
    std::sort(vertices.begin() + first.back(), vertices.end());
    vertices.erase(std::unique(vertices.begin() + first.back(), vertices.end()),
                   vertices.end());
    first.push_back(vertices.size());
    first_number.push_back(first_number.back() + 1 + (end - begin) +
                           cells.first_corner[end] - cells.first_corner[begin]);
  }
}

/** The faces of one cell as VTK has them, by the numbers of its points. */
void append_faces(const CellFaces &cells,
                  const PolyhedronPoints &points,
                  const unsigned int c,
                  std::vector<std::int64_t> &numbers)
{
  const auto begin = points.vertices.begin() + points.first[c];
  const auto end = points.vertices.begin() + points.first[c + 1];
  numbers.push_back(cells.first_face[c + 1] - cells.first_face[c]);
  for (unsigned int f = cells.first_face[c]; f < cells.first_face[c + 1]; ++f)
  {
    numbers.push_back(cells.n_corners(f));
    for (const unsigned int v : cells.corners(f))
      numbers.push_back(std::lower_bound(begin, end, v) -
                        points.vertices.begin());
  }
}

/** A grid of one polyhedron for each cell. */
VtuFile grid_of_polyhedra(const CellFaces &cells,
                          const std::shared_ptr<const PolyhedronPoints> &points)
{
  const auto places = [&cells, points](std::size_t i, std::size_t end,
                                       double *place) {
    for (; i < end; ++i)
    {
      const dealii::Point<3> &x = cells.vertices[points->vertices[i]];
      place = std::copy(x.begin_raw(), x.end_raw(), place);
    }
  };
  const auto faces = [&cells, points](std::size_t i, const std::size_t end,
                                      std::int64_t *place) {
    const auto first = [&](unsigned int c) { return points->first_number[c]; };
    std::vector<std::int64_t> numbers;
    for (unsigned int c = VtuValues::cell_of(i, cells.n_cells(), first);
         i < end; ++c)
    {
      numbers.clear();
      append_faces(cells, *points, c, numbers);
      const std::size_t stop = std::min(end, first(c + 1));
      place = std::copy(numbers.begin() + (i - first(c)),
                        numbers.begin() + (stop - first(c)), place);
      i = stop;
    }
  };
  const auto ends_in = [points](
                           std::vector<std::size_t> PolyhedronPoints::*of) {
    return [points, of](std::size_t c, std::size_t end, std::int64_t *place) {
      std::copy((*points.*of).begin() + c + 1, (*points.*of).begin() + end + 1,
                place);
    };
  };
  return VtuFile::polyhedra(
      {points->vertices.size(), places},
      {cells.n_cells(), ends_in(&PolyhedronPoints::first)},
      {points->first_number.back(), faces},
      {cells.n_cells(), ends_in(&PolyhedronPoints::first_number)});
}
/**
 * What each point has with its cell.
 *
 * @param of a function of the cell and the place, with components to copy.
 */
template <typename Of>
VtuFile::Fill<double>
values_of_points(const CellFaces &cells,
                 const std::shared_ptr<const PolyhedronPoints> &points,
                 const Of &of)
{
  return [&cells, points, of](std::size_t i, const std::size_t end,
                              double *values) {
    for (unsigned int c = VtuValues::cell_of(
             i, cells.n_cells(),
             [&](const unsigned int k) { return points->first[k]; });
         i < end; ++c)
      for (; i < std::min(end, points->first[c + 1]); ++i)
      {
        const auto value = of(c, cells.vertices[points->vertices[i]]);
        // Those of tensors of a higher rank need not lie in one row.
        using Value = std::decay_t<decltype(value)>;
        for (unsigned int k = 0; k < Value::n_independent_components; ++k)
          *values++ = value[Value::unrolled_to_component_indices(k)];
      }
  };
}
} // namespace

void write_blocks_vtu(std::ostream &out, const SpaceResults &answer)
{
  const CellFaces &cells = answer.scene.packing().polyhedra();
  const auto points = std::make_shared<const PolyhedronPoints>(cells);
  VtuFile grid = grid_of_polyhedra(cells, points);
  if (!answer.motion.displacement.empty())
    grid.add_point_vector(
        "displacement",
        values_of_points(cells, points,
                         [&](const unsigned int c, const dealii::Point<3> &x) {
                           const Packing<3> &packing = answer.scene.packing();
                           return c < packing.n_cells()
                                      ? answer.motion.at(c,
                                                         x - packing.centre(c))
                                      : dealii::Tensor<1, 3>();
                         }));
  if (!answer.stresses.empty())
    grid.add_point_tensor(
        "stress",
        values_of_points(cells, points,
                         [&](const unsigned int c, const dealii::Point<3> &x) {
                           return c < answer.stresses.size()
                                      ? answer.stresses[c].at(x)
                                      : dealii::Tensor<2, 3>();
                         }));
  add_fields(grid, polyhedron_fields().arrays(answer));
  grid.write(out);
}

void write_interfaces_vtu(std::ostream &out, const SpaceResults &answer)
{
  const SpacePolygons &polygons = answer.scene.packing().polygons();
  const auto places = [&](std::size_t i, std::size_t end, double *place) {
    for (; i < end; ++i)
      place = std::copy(polygons.vertices[i].begin_raw(),
                        polygons.vertices[i].end_raw(), place);
  };
  const auto ends = [&](std::size_t e, std::size_t end, std::int64_t *place) {
    std::copy(polygons.first.begin() + e + 1, polygons.first.begin() + end + 1,
              place);
  };
  VtuFile grid = VtuFile::separate(VtuFile::Shape::polygon,
                                   {polygons.vertices.size(), places},
                                   {polygons.size(), ends});
  add_fields(grid, face_interface_fields().arrays(answer));
  grid.write(out);
}
} // namespace Voussoir
