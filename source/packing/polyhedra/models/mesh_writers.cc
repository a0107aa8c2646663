// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/models/cell_vertices.h>
#include <voussoir/packing/polyhedra/models/writers.h>

#include <limits>
#include <ostream>

namespace Voussoir
{
namespace
{
/** The digits with which a number is read back as it is. */
constexpr int all_digits = std::numeric_limits<double>::max_digits10;

void write_vertices(std::ostream &out,
                    const char *const begin,
                    const CellFaces &cells,
                    const std::vector<unsigned int> &vertices)
{
  for (const unsigned int vertex : vertices)
  {
    const dealii::Point<3> &p = cells.vertices[vertex];
    out << begin << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  }
}
} // namespace

void write_off_model(std::ostream &out, const CellFaces &cells)
{
  const auto precision = out.precision(all_digits);
  std::size_t n_vertices = 0;
  for (unsigned int cell = 0; cell < cells.n_cells(); ++cell)
    n_vertices += vertices_of_cell(cells, cell).size();
  out << "OFF\n" << n_vertices << ' ' << cells.n_faces() << " 0\n";
  for (unsigned int cell = 0; cell < cells.n_cells(); ++cell)
    write_vertices(out, "", cells, vertices_of_cell(cells, cell));
  std::size_t first = 0;
  for (unsigned int cell = 0; cell < cells.n_cells(); ++cell)
  {
    const std::vector<unsigned int> vertices = vertices_of_cell(cells, cell);
    for (unsigned int face = cells.first_face[cell];
         face < cells.first_face[cell + 1]; ++face)
    {
      out << cells.n_corners(face);
      for (const unsigned int corner : cells.corners(face))
        out << ' ' << first + place_in_list(vertices, corner);
      out << '\n';
    }
    first += vertices.size();
  }
  out.precision(precision);
}

void write_obj_model(std::ostream &out, const CellFaces &cells)
{
  const auto precision = out.precision(all_digits);
  std::size_t first = 1;
  for (unsigned int cell = 0; cell < cells.n_cells(); ++cell)
  {
    const std::vector<unsigned int> vertices = vertices_of_cell(cells, cell);
    out << "o " << group_name_of(cells, cell) << '\n';
    write_vertices(out, "v ", cells, vertices);
    for (unsigned int face = cells.first_face[cell];
         face < cells.first_face[cell + 1]; ++face)
    {
      out << 'f';
      for (const unsigned int corner : cells.corners(face))
        out << ' ' << first + place_in_list(vertices, corner);
      out << '\n';
    }
    first += vertices.size();
  }
  out.precision(precision);
}
} // namespace Voussoir
