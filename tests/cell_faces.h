// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_cell_faces_h
#define voussoir_tests_cell_faces_h

#include <voussoir/base/random.h>
#include <voussoir/packing/polyhedra/cell_faces.h>
#include <voussoir/packing/polyhedra/face_contacts.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

// Polyhedra for tests, and what is done to them.

/** Add a prism over a counterclockwise polygon, from height z0 to z1. */
inline void add_prism(Voussoir::CellFaces &cells,
                      const std::vector<dealii::Point<2>> &base,
                      const double z0,
                      const double z1)
{
  const unsigned int n = base.size(), first = cells.vertices.size();
  for (const double z : {z0, z1})
    for (const dealii::Point<2> &p : base)
      cells.vertices.emplace_back(p[0], p[1], z);
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
    const unsigned int j = (i + 1) % n;
    cells.add_face(std::vector<unsigned int>{first + i, first + j,
                                             first + n + j, first + n + i});
  }
  cells.end_cell();
}

/** Add a box; its faces are bottom, top, y0, x1, y1, x0. */
inline void add_box(Voussoir::CellFaces &cells,
                    const dealii::Point<3> &low,
                    const dealii::Point<3> &high)
{
  add_prism(cells,
            {{low[0], low[1]},
             {high[0], low[1]},
             {high[0], high[1]},
             {low[0], high[1]}},
            low[2], high[2]);
}

/** Add a pyramid over a counterclockwise polygon at a height. */
inline void add_pyramid(Voussoir::CellFaces &cells,
                        const std::vector<dealii::Point<2>> &base,
                        const double z,
                        const dealii::Point<3> &tip)
{
  const unsigned int n = base.size(), first = cells.vertices.size();
  for (const dealii::Point<2> &p : base)
    cells.vertices.emplace_back(p[0], p[1], z);
  cells.vertices.push_back(tip);
  const bool points_up = tip[2] > z;
  std::vector<unsigned int> loop(n);
  for (unsigned int i = 0; i < n; ++i)
    loop[i] = first + (points_up ? n - 1 - i : i);
  cells.add_face(loop);
  for (unsigned int i = 0; i < n; ++i)
  {
    const unsigned int j = (i + 1) % n;
    cells.add_face(
        points_up ? std::vector<unsigned int>{first + i, first + j, first + n}
                  : std::vector<unsigned int>{first + j, first + i, first + n});
  }
  cells.end_cell();
}

/** Add all cells of others. */
inline void add_cells(Voussoir::CellFaces &cells,
                      const Voussoir::CellFaces &others)
{
  const unsigned int first = cells.vertices.size();
  cells.vertices.insert(cells.vertices.end(), others.vertices.begin(),
                        others.vertices.end());
  for (unsigned int c = 0; c < others.n_cells(); ++c)
  {
    for (unsigned int f = others.first_face[c]; f < others.first_face[c + 1];
         ++f)
    {
      std::vector<unsigned int> loop;
      for (const unsigned int v : others.corners(f))
        loop.push_back(first + v);
      cells.add_face(loop);
    }
    cells.end_cell();
  }
}

/** Add a prism along y over a polygon in x and z, counterclockwise there. */
inline void add_bar(Voussoir::CellFaces &cells,
                    const std::vector<dealii::Point<2>> &section,
                    const double y0,
                    const double y1)
{
  Voussoir::CellFaces upright;
  add_prism(upright, section, -y1, -y0);
  for (dealii::Point<3> &p : upright.vertices)
    p = {p[0], -p[2], p[1]};
  add_cells(cells, upright);
}

/** A wall in running bond, of bricks 2 x 1 x 0.5, some leaves thick. */
inline Voussoir::CellFaces brick_wall(const unsigned int n_bricks,
                                      const unsigned int n_leaves,
                                      const unsigned int n_courses)
{
  Voussoir::CellFaces cells;
  for (unsigned int k = 0; k < n_courses; ++k)
    for (unsigned int j = 0; j < n_leaves; ++j)
      for (unsigned int i = 0; i < n_bricks; ++i)
      {
        const double x = 2. * i + k % 2, y = 1. * j, z = 0.5 * k;
        add_box(cells, {x, y, z}, {x + 2., y + 1., z + 0.5});
      }
  return cells;
}

/** The cells with every vertex where @p map takes it. */
template <typename Map>
Voussoir::CellFaces mapped(Voussoir::CellFaces cells, const Map &map)
{
  for (dealii::Point<3> &vertex : cells.vertices)
    vertex = map(vertex);
  return cells;
}

/** A rotation drawn at random: from a unit quaternion. */
inline dealii::Tensor<2, 3> random_rotation(Voussoir::Random &random)
{
  double q[4], square = 0.;
  for (double &entry : q)
  {
    entry = random.normal();
    square += entry * entry;
  }
  for (double &entry : q)
    entry /= std::sqrt(square);
  dealii::Tensor<2, 3> R;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
    R[i][i] = 1. - 2. * (q[1 + j] * q[1 + j] + q[1 + k] * q[1 + k]);
    R[i][j] = 2. * (q[1 + i] * q[1 + j] - q[0] * q[1 + k]);
    R[i][k] = 2. * (q[1 + i] * q[1 + k] + q[0] * q[1 + j]);
  }
  return R;
}

/** Numbers below @p n in a random order. */
inline std::vector<unsigned int> random_order(const unsigned int n,
                                              Voussoir::Random &random)
{
  std::vector<unsigned int> order(n);
  std::iota(order.begin(), order.end(), 0);
  for (unsigned int i = n; i > 1; --i)
    std::swap(order[i - 1], order[static_cast<unsigned int>(random() * i)]);
  return order;
}

/** The cells in another order, with other numbers of the vertices. */
inline Voussoir::CellFaces renumbered(const Voussoir::CellFaces &cells,
                                      const std::vector<unsigned int> &order,
                                      Voussoir::Random &random)
{
  const std::vector<unsigned int> number =
      random_order(cells.vertices.size(), random);
  Voussoir::CellFaces others;
  others.vertices.resize(cells.vertices.size());
  for (unsigned int v = 0; v < number.size(); ++v)
    others.vertices[number[v]] = cells.vertices[v];
  for (const unsigned int c : order)
  {
    for (unsigned int f = cells.first_face[c]; f < cells.first_face[c + 1]; ++f)
    {
      std::vector<unsigned int> loop;
      for (const unsigned int v : cells.corners(f))
        loop.push_back(number[v]);
      // Another vertex comes first.
      std::rotate(loop.begin(), loop.begin() + f % loop.size(), loop.end());
      others.add_face(loop);
    }
    others.end_cell();
  }
  return others;
}

/** The areas of some polygons together; L^2. */
inline double total_area(const Voussoir::SpacePolygons &polygons)
{
  double area = 0.;
  for (unsigned int k = 0; k < polygons.size(); ++k)
    area += Voussoir::moments_of(polygons[k]).area();
  return area;
}

/** The vector area of a face out of its cell; L^2. */
inline dealii::Tensor<1, 3> vector_area(const Voussoir::CellFaces &cells,
                                        const unsigned int face)
{
  const std::vector<dealii::Point<3>> polygon = cells.polygon(face);
  return Voussoir::moments_of(
             dealii::ArrayView<const dealii::Point<3>>(polygon))
      .vector_area;
}

/**
 * The largest difference between the vector area of a face and those of its
 * patches and free parts, over the area of the face.
 */
inline double uncovered(const Voussoir::CellFaces &cells,
                        const Voussoir::FaceContacts &contacts)
{
  std::vector<dealii::Tensor<1, 3>> rest;
  for (unsigned int f = 0; f < cells.n_faces(); ++f)
    rest.push_back(vector_area(cells, f));
  for (unsigned int k = 0; k < contacts.patches.size(); ++k)
  {
    const auto area = Voussoir::moments_of(contacts.patches[k]).vector_area;
    rest[contacts.faces[k][0]] -= area;
    rest[contacts.faces[k][1]] += area;
  }
  for (unsigned int k = 0; k < contacts.free_parts.size(); ++k)
    rest[contacts.free_faces[k]] -=
        Voussoir::moments_of(contacts.free_parts[k]).vector_area;
  double largest = 0.;
  for (unsigned int f = 0; f < cells.n_faces(); ++f)
    largest = std::max(largest, rest[f].norm() / vector_area(cells, f).norm());
  return largest;
}

#endif
