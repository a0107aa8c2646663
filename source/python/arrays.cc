// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/python/arrays.h>

#include <cstdint>
#include <map>
#include <pybind11/stl.h>
#include <string>
#include <type_traits>
#include <utility>

namespace Voussoir
{
namespace py = pybind11;

namespace
{
/** An array of shape (n, dim) of points. */
template <typename Points>
auto array_of(const Points &points)
{
  constexpr int dim = std::decay_t<decltype(points[0])>::dimension;
  py::array_t<double> array({py::ssize_t(points.size()), py::ssize_t(dim)});
  for (unsigned int i = 0; i < points.size(); ++i)
    for (int d = 0; d < dim; ++d)
      array.mutable_at(i, d) = points[i][d];
  return array;
}

/** Its vertices and faces in a pair. */
using VerticesAndFaces =
    std::pair<py::array_t<double>, std::vector<std::vector<std::int64_t>>>;

/** Polyhedron @p number as it was given. */
VerticesAndFaces vertices_and_faces(const py::handle &polyhedron,
                                    const unsigned int number)
{
  const std::string expected = text(
      "polyhedron ", number,
      " must be a pair: an array of its vertices, of shape (n, 3), and its "
      "faces, lists of the numbers of vertices");
  try
  {
    const auto pair = polyhedron.cast<VerticesAndFaces>();
    if (pair.first.ndim() == 2 && pair.first.shape(1) == 3)
      return pair;
  }
  catch (const py::cast_error &)
  {}
  throw py::value_error(expected);
}
} // namespace

PolygonList list_of(const std::vector<py::array_t<double>> &polygons)
{
  PolygonList list;
  list.file = "the arrays";
  list.record_name = "polygon";
  for (const auto &corners : polygons)
  {
    if (corners.ndim() != 2 || corners.shape(1) != 2)
      throw py::value_error("Each polygon is an array of shape (n, 2), "
                            "with the x and y of its corners.");
    list.polygons.emplace_back();
    PolygonList::Polygon &polygon = list.polygons.back();
    polygon.record = list.polygons.size();
    for (py::ssize_t i = 0; i < corners.shape(0); ++i)
      polygon.ring.emplace_back(corners.at(i, 0), corners.at(i, 1));
  }
  return list;
}

BlockMeshes meshes_of(const py::sequence &polyhedra)
{
  BlockMeshes meshes;
  meshes.file = "the arrays";
  meshes.record_name = "polyhedron";
  for (const py::handle &polyhedron : polyhedra)
  {
    BlockMesh block;
    block.record = meshes.blocks.size() + 1;
    const auto [vertices, faces] = vertices_and_faces(polyhedron, block.record);
    const py::ssize_t n = vertices.shape(0);
    for (py::ssize_t i = 0; i < n; ++i)
      block.vertices.emplace_back(vertices.at(i, 0), vertices.at(i, 1),
                                  vertices.at(i, 2));
    for (const std::vector<std::int64_t> &face : faces)
    {
      for (const std::int64_t vertex : face)
        if (vertex < 0 || vertex >= n)
          throw py::value_error(text("polyhedron ", block.record,
                                     " has a face with the vertex ", vertex,
                                     ", and its vertices are 0 to ", n - 1));
      block.faces.add(face);
    }
    meshes.blocks.push_back(std::move(block));
  }
  return meshes;
}

std::vector<py::array_t<double>> polygons_of(const Packing<2> &packing)
{
  std::vector<py::array_t<double>> polygons;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    std::vector<dealii::Point<2>> corners;
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      corners.push_back(packing.vertex(c, i));
    polygons.push_back(array_of(corners));
  }
  return polygons;
}

py::list polyhedra_of(const Packing<3> &packing)
{
  const CellFaces &cells = packing.polyhedra();
  py::list polyhedra;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
  {
    // The vertices of a cell, in the order in which its faces come to them.
    std::map<unsigned int, unsigned int> numbers;
    std::vector<dealii::Point<3>> vertices;
    std::vector<std::vector<unsigned int>> faces;
    for (unsigned int f = cells.first_face[c]; f < cells.first_face[c + 1]; ++f)
    {
      faces.emplace_back();
      for (const unsigned int vertex : cells.corners(f))
      {
        const auto [place, is_new] = numbers.emplace(vertex, vertices.size());
        if (is_new)
          vertices.push_back(cells.vertices[vertex]);
        faces.back().push_back(place->second);
      }
    }
    polyhedra.append(py::make_tuple(array_of(vertices), faces));
  }
  return polyhedra;
}

std::vector<py::array_t<double>>
interface_polygons_of(const Packing<3> &packing)
{
  std::vector<py::array_t<double>> polygons;
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
    polygons.push_back(array_of(packing.polygon(e)));
  return polygons;
}
} // namespace Voussoir
