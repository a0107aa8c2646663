// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_output_boxes_h
#define voussoir_tests_output_boxes_h

#include <voussoir/packing/polyhedra/cell_faces.h>
#include <voussoir/packing/polyhedra/face_contacts.h>

#include <deal.II/base/bounding_box.h>

#include <algorithm>
#include <array>
#include <vector>

using Box = dealii::BoundingBox<3>;

inline Box box_between(const dealii::Point<3> &low,
                       const dealii::Point<3> &high)
{
  return Box(std::make_pair(low, high));
}

/**
 * Boxes as polyhedra with eight vertices each. The faces of a box are numbered
 * as -x, +x, -y, +y, -z, +z.
 */
inline Voussoir::CellFaces boxes(const std::vector<Box> &list)
{
  Voussoir::CellFaces cells;
  for (const Box &box : list)
  {
    const unsigned int v = cells.vertices.size();
    for (unsigned int k = 0; k < 8; ++k)
      cells.vertices.push_back(box.vertex(k));
    for (const std::array<unsigned int, 4> &loop :
         {std::array<unsigned int, 4>{{v, v + 4, v + 6, v + 2}},
          {{v + 1, v + 3, v + 7, v + 5}},
          {{v, v + 1, v + 5, v + 4}},
          {{v + 2, v + 6, v + 7, v + 3}},
          {{v, v + 2, v + 3, v + 1}},
          {{v + 4, v + 5, v + 7, v + 6}}})
      cells.add_face(loop);
    cells.end_cell();
  }
  return cells;
}

/** The rectangles in which boxes touch, for coordinates that are exact. */
inline Voussoir::FaceContacts contacts_of(const std::vector<Box> &list)
{
  Voussoir::FaceContacts contacts;
  for (unsigned int a = 0; a < list.size(); ++a)
    for (unsigned int b = a + 1; b < list.size(); ++b)
      for (unsigned int side = 0; side < 6; ++side)
      {
        const unsigned int d = side / 2, u = (d + 1) % 3, v = (d + 2) % 3;
        const bool up = side % 2 == 1;
        const double at = up ? list[a].upper_bound(d) : list[a].lower_bound(d);
        if (at != (up ? list[b].lower_bound(d) : list[b].upper_bound(d)))
          continue;
        std::array<std::array<double, 2>, 3> range;
        for (const unsigned int e : {u, v})
          range[e] = {
              {std::max(list[a].lower_bound(e), list[b].lower_bound(e)),
               std::min(list[a].upper_bound(e), list[b].upper_bound(e))}};
        if (range[u][0] >= range[u][1] || range[v][0] >= range[v][1])
          continue;
        std::vector<dealii::Point<3>> corners(4);
        for (unsigned int k = 0; k < 4; ++k)
        {
          const unsigned int right = k == 1 || k == 2, above = k >= 2;
          corners[k][d] = at;
          corners[k][u] = range[u][right];
          corners[k][v] = range[v][above];
        }
        if (!up)
          std::reverse(corners.begin(), corners.end());
        contacts.faces.push_back({{6 * a + side, 6 * b + (side ^ 1U)}});
        contacts.patches.add(corners);
      }
  return contacts;
}

/** A prism of unit depth in y over a polygon that is clockwise in (x, z). */
inline void add_prism(Voussoir::CellFaces &cells,
                      const std::vector<dealii::Point<2>> &polygon)
{
  const unsigned int n = polygon.size(), v = cells.vertices.size();
  std::vector<unsigned int> front, back;
  for (const double y : {0., 1.})
    for (const dealii::Point<2> &p : polygon)
      cells.vertices.emplace_back(p[0], y, p[1]);
  for (unsigned int i = 0; i < n; ++i)
  {
    front.push_back(v + n - 1 - i);
    back.push_back(v + n + i);
  }
  cells.add_face(front);
  cells.add_face(back);
  for (unsigned int i = 0; i < n; ++i)
  {
    const unsigned int j = (i + 1) % n;
    cells.add_face(
        std::array<unsigned int, 4>{{v + i, v + j, v + n + j, v + n + i}});
  }
  cells.end_cell();
}

/** A wall in running bond on a slab that does not move, which is the last. */
inline std::vector<Box> wall_on_slab(const unsigned int n_courses,
                                     const unsigned int n_bricks)
{
  std::vector<Box> list;
  for (unsigned int course = 0; course < n_courses; ++course)
    for (unsigned int b = 0; b < n_bricks + course % 2; ++b)
    {
      const double half = course % 2;
      const double from = std::max(0., b - 0.5 * half);
      const double to = std::min(1. * n_bricks, b + 1 - 0.5 * half);
      list.push_back(
          box_between({from, 0., 0.5 * course}, {to, 0.5, 0.5 * (course + 1)}));
    }
  list.push_back(box_between({-0.5, -0.25, -0.25}, {n_bricks + 0.5, 0.75, 0.}));
  return list;
}

#endif
