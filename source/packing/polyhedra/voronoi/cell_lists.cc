// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/invalid_index.h>
#include <voussoir/packing/polyhedra/voronoi/cell_lists.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::Point;

/** Gathers faces by cell; one object, used once. */
class CellListBuilder
{
public:
  CellListBuilder(const VertexFaces &faces,
                  const std::vector<Point<3>> &places,
                  const unsigned int n_cells)
      : faces(faces), places(places), n_cells(n_cells),
        number(places.size(), invalid_index),
        lower_face(faces.size(), invalid_index)
  {}

  CellFaces build()
  {
    gather_faces();
    reserve();
    for (unsigned int c = 0; c < n_cells; ++c)
    {
      for (unsigned int i = first[c]; i < first[c + 1]; ++i)
        add_face(c, face_at[i]);
      cells.end_cell();
    }
    return std::move(cells);
  }

private:
  bool is_shared(const unsigned int face) const
  {
    return faces.sides[face][1] < n_cells;
  }

  /** What is behind a @p face of a cell, and which of them it is. */
  std::tuple<unsigned int, unsigned int> behind(const unsigned int face,
                                                const unsigned int cell) const
  {
    const auto &sides = faces.sides[face];
    return {sides[0] == cell ? sides[1] : sides[0], face};
  }

  /** Sort the faces by cell, and those of a cell by what is behind them. */
  void gather_faces()
  {
    first.assign(n_cells + 1, 0);
    for (unsigned int f = 0; f < faces.size(); ++f)
      for (unsigned int side = 0; side < (is_shared(f) ? 2 : 1); ++side)
        ++first[faces.sides[f][side] + 1];
    for (unsigned int c = 0; c < n_cells; ++c)
      first[c + 1] += first[c];
    face_at.resize(first[n_cells]);
    std::vector<unsigned int> next(first.begin(), first.end() - 1);
    for (unsigned int f = 0; f < faces.size(); ++f)
      for (unsigned int side = 0; side < (is_shared(f) ? 2 : 1); ++side)
        face_at[next[faces.sides[f][side]]++] = f;
    for (unsigned int c = 0; c < n_cells; ++c)
      std::sort(face_at.begin() + first[c], face_at.begin() + first[c + 1],
                [&](const unsigned int a, const unsigned int b) {
                  return behind(a, c) < behind(b, c);
                });
  }

  void reserve()
  {
    unsigned int n_shared = 0, n_corners = 0;
    for (unsigned int f = 0; f < faces.size(); ++f)
    {
      n_shared += is_shared(f);
      n_corners += (is_shared(f) ? 2 : 1) * faces[f].size();
    }
    cells.vertices.reserve(places.size());
    cells.loops.reserve(n_corners);
    cells.first_corner.reserve(face_at.size() + 1);
    cells.first_face.reserve(n_cells + 1);
    cells.shared.reserve(n_shared);
  }

  void add_face(const unsigned int cell, const unsigned int face)
  {
    const auto corners = faces[face];
    const unsigned int n = corners.size();
    // From the lowest place on, whatever made the loop.
    unsigned int begin = 0;
    for (unsigned int i = 1; i < n; ++i)
      if (is_lower(places[corners[i]], places[corners[begin]]))
        begin = i;
    const bool runs_back = faces.sides[face][0] != cell;
    for (unsigned int i = 0; i < n; ++i)
      cells.loops.push_back(
          numbered(corners[(begin + (runs_back ? n - i : i)) % n]));
    if (is_shared(face) && lower_face[face] == invalid_index)
      lower_face[face] = cells.n_faces();
    else if (is_shared(face))
      cells.shared.push_back({{lower_face[face], cells.n_faces()}});
    cells.first_corner.push_back(cells.loops.size());
  }

  static bool is_lower(const Point<3> &a, const Point<3> &b)
  {
    return std::tie(a[0], a[1], a[2]) < std::tie(b[0], b[1], b[2]);
  }

  /** The number of a vertex among those in use. */
  unsigned int numbered(const unsigned int v)
  {
    if (number[v] == invalid_index)
    {
      number[v] = cells.vertices.size();
      cells.vertices.push_back(places[v]);
    }
    return number[v];
  }

  const VertexFaces &faces;
  const std::vector<Point<3>> &places;
  const unsigned int n_cells;

  /** The faces of one cell after the other, and where those of each start. */
  std::vector<unsigned int> face_at, first;
  /** Of the vertices in use. */
  std::vector<unsigned int> number;
  /** The face of the lower cell, for each that is shared. */
  std::vector<unsigned int> lower_face;
  CellFaces cells;
};
} // namespace

CellFaces cells_of(const VertexFaces &faces,
                   const std::vector<Point<3>> &places,
                   const unsigned int n_cells)
{
  return CellListBuilder(faces, places, n_cells).build();
}
} // namespace Voussoir
