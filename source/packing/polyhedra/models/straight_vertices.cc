// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/models/mend_surface.h>

#include <algorithm>
#include <array>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;
using DefectKind = ModelDefect::Kind;

namespace
{
/** The numbers of faces that have each vertex. */
std::vector<unsigned int> numbers_of_faces(const Surface &surface)
{
  std::vector<unsigned int> n_faces(surface.vertices.size(), 0);
  for (const unsigned int vertex : surface.faces.corners)
    ++n_faces[vertex];
  return n_faces;
}

/** The vertices before and behind one in a loop. */
std::array<unsigned int, 2> beside(const std::vector<unsigned int> &loop,
                                   const unsigned int vertex)
{
  const std::size_t n = loop.size();
  const std::size_t i =
      std::find(loop.begin(), loop.end(), vertex) - loop.begin();
  return {{loop[(i + n - 1) % n], loop[(i + 1) % n]}};
}

bool is_between(const Point<3> &p,
                const Point<3> &a,
                const Point<3> &b,
                const double distance)
{
  const Tensor<1, 3> line = b - a;
  const double length = line.norm();
  const double along = line * (p - a);
  return along > 0. && along < length * length &&
         cross_product_3d(line, p - a).norm() <= distance * length;
}
} // namespace

void drop_straight_vertices(MendedSurface &mended, const double distance)
{
  Surface &surface = mended.surface;
  const std::vector<unsigned int> n_faces = numbers_of_faces(surface);
  if (std::find(n_faces.begin(), n_faces.end(), 2) == n_faces.end())
    return;
  std::vector<std::vector<unsigned int>> loops;
  std::vector<std::vector<unsigned int>> faces_of(n_faces.size());
  for (unsigned int f = 0; f < surface.faces.size(); ++f)
  {
    loops.emplace_back(surface.faces[f].begin(), surface.faces[f].end());
    for (const unsigned int v : loops.back())
      if (n_faces[v] == 2)
        faces_of[v].push_back(f);
  }
  ModelDefect dropped = {DefectKind::straight_vertex};
  dropped.count = 0;
  for (unsigned int v = 0; v < n_faces.size(); ++v)
  {
    if (n_faces[v] != 2 || faces_of[v][0] == faces_of[v][1])
      continue;
    std::vector<unsigned int> &one = loops[faces_of[v][0]];
    std::vector<unsigned int> &two = loops[faces_of[v][1]];
    const auto [a, b] = beside(one, v);
    if (one.size() == 3 || two.size() == 3 ||
        beside(two, v) != std::array<unsigned int, 2>{{b, a}} ||
        !is_between(surface.vertices[v], surface.vertices[a],
                    surface.vertices[b], distance))
      continue;
    for (std::vector<unsigned int> *const loop : {&one, &two})
      loop->erase(std::find(loop->begin(), loop->end(), v));
    if (dropped.count++ == 0)
    {
      dropped.face = surface.source[faces_of[v][0]];
      dropped.place = surface.vertices[v];
    }
  }
  if (dropped.count == 0)
    return;
  surface.faces = FaceLoops();
  for (const std::vector<unsigned int> &loop : loops)
    surface.faces.add(loop);
  mended.defects.push_back(dropped);
}
} // namespace Voussoir
