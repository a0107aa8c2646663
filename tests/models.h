// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_models_h
#define voussoir_tests_models_h

#include <voussoir/packing/polyhedra/cell_moments.h>
#include <voussoir/packing/polyhedra/models/model_cells.h>
#include <voussoir/packing/polyhedra/models/readers.h>
#include <voussoir/packing/polyhedra/models/writers.h>

#include "polygons.h"
#include "tests.h"
#include "volumes.h"
#include <string>
#include <vector>

// What the tests of models of blocks share.

/** A surface as a test makes it. */
struct Shape
{
  std::vector<dealii::Point<3>> vertices;
  std::vector<std::vector<unsigned int>> faces;
};

/** A box, with its faces counterclockwise as seen from outside. */
inline Shape box(const dealii::Point<3> &low, const dealii::Point<3> &high)
{
  Shape shape;
  for (unsigned int v = 0; v < 8; ++v)
    shape.vertices.emplace_back((v & 1 ? high : low)[0],
                                (v & 2 ? high : low)[1],
                                (v & 4 ? high : low)[2]);
  shape.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                 {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return shape;
}

/** A unit cube with its lower corner at (x, y, z). */
inline Shape cube(const double x = 0., const double y = 0., const double z = 0.)
{
  return box({x, y, z}, {x + 1., y + 1., z + 1.});
}

/** Every face cut into triangles from its first vertex. */
inline Shape triangulated(const Shape &shape)
{
  Shape cut = {shape.vertices, {}};
  for (const std::vector<unsigned int> &face : shape.faces)
    for (unsigned int i = 1; i + 1 < face.size(); ++i)
      cut.faces.push_back({face[0], face[i], face[i + 1]});
  return cut;
}

/** Every face with vertices of its own. */
inline Shape unwelded(const Shape &shape)
{
  Shape cut;
  for (const std::vector<unsigned int> &face : shape.faces)
  {
    cut.faces.emplace_back();
    for (const unsigned int vertex : face)
    {
      cut.faces.back().push_back(cut.vertices.size());
      cut.vertices.push_back(shape.vertices[vertex]);
    }
  }
  return cut;
}

/** A prism over a polygon in the plane, from z = 0 to the height. */
inline Shape prism(const std::vector<dealii::Point<2>> &polygon,
                   const double height)
{
  Shape shape;
  const unsigned int n = polygon.size();
  for (const double z : {0., height})
    for (const dealii::Point<2> &p : polygon)
      shape.vertices.emplace_back(p[0], p[1], z);
  shape.faces.resize(2);
  for (unsigned int i = 0; i < n; ++i)
  {
    shape.faces[0].push_back((n - i) % n);
    shape.faces[1].push_back(n + i);
    shape.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  return shape;
}

inline Voussoir::BlockMesh block_of(const Shape &shape,
                                    const std::string &name = "")
{
  Voussoir::BlockMesh block;
  block.vertices = shape.vertices;
  for (const std::vector<unsigned int> &face : shape.faces)
    block.faces.add(face);
  block.name = name;
  return block;
}

/** A list of blocks without names, numbered from zero. */
inline Voussoir::BlockMeshes
meshes_of(const std::vector<Voussoir::BlockMesh> &blocks)
{
  Voussoir::BlockMeshes meshes;
  meshes.file = "test.obj";
  meshes.blocks = blocks;
  for (unsigned int b = 0; b < blocks.size(); ++b)
    meshes.blocks[b].record = b;
  return meshes;
}

inline Voussoir::ModelCells cells_of(const Shape &shape,
                                     const Voussoir::ModelOptions &options = {})
{
  return cells_of_model(meshes_of({block_of(shape)}), options);
}

/** "o NAME" and a shape as lines of an OBJ file, by backward numbers. */
inline std::string obj_of(const std::string &name, const Shape &shape)
{
  std::string lines = "o " + name + "\n";
  for (const dealii::Point<3> &p : shape.vertices)
    lines +=
        "v " + digits(p[0]) + " " + digits(p[1]) + " " + digits(p[2]) + "\n";
  for (const std::vector<unsigned int> &face : shape.faces)
  {
    lines += "f";
    for (const unsigned int vertex : face)
      lines += " -" + std::to_string(shape.vertices.size() - vertex);
    lines += "\n";
  }
  return lines;
}

/** The number of all that a kind of defect counts. */
inline unsigned int count_of(const Voussoir::ModelCells &model,
                             const Voussoir::ModelDefect::Kind kind)
{
  unsigned int count = 0;
  for (const Voussoir::ModelDefect &defect : model.defects)
    count += defect.kind == kind ? defect.count : 0;
  return count;
}

/** True if all cells are closed, and no face has a vertex twice. */
inline bool are_sound(const Voussoir::CellFaces &cells)
{
  bool are = true;
  for (unsigned int cell = 0; cell < cells.n_cells(); ++cell)
    are &=
        open_edges(cells, cell).empty() && moments_of(cells, cell).volume > 0.;
  for (unsigned int face = 0; face < cells.n_faces(); ++face)
  {
    std::vector<unsigned int> corners(cells.corners(face).begin(),
                                      cells.corners(face).end());
    std::sort(corners.begin(), corners.end());
    are &= corners.size() > 2 &&
           std::adjacent_find(corners.begin(), corners.end()) == corners.end();
  }
  return are;
}

#endif
