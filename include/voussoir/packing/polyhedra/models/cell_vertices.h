// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_cell_vertices_h
#define voussoir_packing_polyhedra_models_cell_vertices_h

#include <voussoir/packing/polyhedra/cell_faces.h>

#include <algorithm>
#include <string>
#include <vector>

namespace Voussoir
{
/** The numbers of the vertices that a cell has, ascending. */
inline std::vector<unsigned int> vertices_of_cell(const CellFaces &cells,
                                                  const unsigned int cell)
{
  std::vector<unsigned int> vertices(
      cells.loops.begin() + cells.first_corner[cells.first_face[cell]],
      cells.loops.begin() + cells.first_corner[cells.first_face[cell + 1]]);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/** Where a number that is there stands in an ascending list. */
inline std::size_t place_in_list(const std::vector<unsigned int> &list,
                                 const unsigned int number)
{
  return std::lower_bound(list.begin(), list.end(), number) - list.begin();
}

/** The name of the group of a cell. */
inline std::string group_name_of(const CellFaces &cells,
                                 const unsigned int cell)
{
  if (cells.group_names.empty())
    return "block";
  return cells.group_names[cells.group.empty() ? 0 : cells.group[cell]];
}
} // namespace Voussoir

#endif
