// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/invalid_index.h>
#include <voussoir/packing/polyhedra/voronoi/narrow_faces.h>
#include <voussoir/packing/polyhedra/voronoi/small_features.h>

#include <boost/pending/disjoint_sets.hpp>

#include <array>
#include <utility>

namespace Voussoir
{
namespace
{
/**
 * The length of edges whose ends become one, over the least width of a face:
 * faces that are wide enough to stay are not turned over when their vertices
 * move by as much.
 */
constexpr double joined_edge = 0.25;

/**
 * The distance at which vertices next to each other along a narrow face become
 * one, over the least width of a face: where many vertices lie close together
 * they are one rather than a tangle of narrow faces.
 */
constexpr double joined_along_chord = 4.;

/** For each vertex the one that stands for all that are the same point. */
std::vector<unsigned int> stand_ins(const VertexFaces &faces,
                                    const FaceVertices &vertices,
                                    const double resolution)
{
  const unsigned int n = vertices.places.size();
  boost::disjoint_sets_with_storage<> sets(n);
  const auto join = [&](const unsigned int a, const unsigned int b,
                        const double distance) {
    if (vertices.places[a].distance_square(vertices.places[b]) <=
        distance * distance)
      sets.union_set(a, b);
  };
  for (unsigned int f = 0; f < faces.size(); ++f)
  {
    const auto corners = faces[f];
    for (unsigned int i = 0; i < corners.size(); ++i)
      join(corners[i], corners[(i + 1) % corners.size()],
           joined_edge * resolution);
    const NarrowLoop loop(corners, vertices.places);
    if (!loop.is_narrower_than(resolution,
                               vertices.sites.direction(faces.sides[f])))
      continue;
    const std::vector<unsigned int> along = loop.along_chord();
    for (unsigned int i = 0; i + 1 < along.size(); ++i)
      join(along[i], along[i + 1], joined_along_chord * resolution);
  }

  // Of the vertices in a set, keep the one that lies in most planes.
  std::vector<unsigned int> kept(n, invalid_index), stand_in(n);
  for (unsigned int v = 0; v < n; ++v)
  {
    unsigned int &k = kept[sets.find_set(v)];
    if (k == invalid_index || vertices.n_planes[v] > vertices.n_planes[k])
      k = v;
  }
  for (unsigned int v = 0; v < n; ++v)
    stand_in[v] = kept[sets.find_set(v)];
  return stand_in;
}

/** Vertices at which two edges only meet, in one line. */
class StraightVertices
{
public:
  StraightVertices(const VertexFaces &faces, const FaceVertices &vertices)
      : places(vertices.places),
        neighbours(places.size(), {{invalid_index, invalid_index}}),
        is_end(places.size(), false)
  {
    for (unsigned int f = 0; f < faces.size(); ++f)
    {
      const auto corners = faces[f];
      const unsigned int n = corners.size();
      for (unsigned int i = 0; i < n; ++i)
      {
        note(corners[i], corners[(i + 1) % n]);
        note(corners[(i + 1) % n], corners[i]);
      }
    }
    for (unsigned int v = 0; v < places.size(); ++v)
      if (vertices.n_planes[v] == 3)
        is_end[v] = true;
  }

  /** True if @p v has two neighbours and is within the resolution of a line. */
  bool contains(const unsigned int v, const double resolution) const
  {
    if (is_end[v] || neighbours[v][1] == invalid_index)
      return false;
    const dealii::Point<3> &a = places[neighbours[v][0]];
    return cross_product_3d(places[v] - a, places[neighbours[v][1]] - a)
               .norm() <= resolution * places[neighbours[v][1]].distance(a);
  }

private:
  void note(const unsigned int v, const unsigned int neighbour)
  {
    for (unsigned int &known : neighbours[v])
    {
      if (known == invalid_index)
        known = neighbour;
      if (known == neighbour)
        return;
    }
    is_end[v] = true;
  }

  const std::vector<dealii::Point<3>> &places;
  std::vector<std::array<unsigned int, 2>> neighbours;
  /** True for vertices with other edges, and corners of the domain. */
  std::vector<bool> is_end;
};

/** The faces with vertices that are close to each other joined to one. */
VertexFaces with_vertices_joined(const VertexFaces &faces,
                                 const FaceVertices &vertices,
                                 const double resolution)
{
  const std::vector<unsigned int> stand_in =
      stand_ins(faces, vertices, resolution);
  VertexFaces result;
  result.sides.reserve(faces.sides.size());
  result.corners.reserve(faces.corners.size());
  result.first.reserve(faces.first.size());
  std::vector<unsigned int> loop;
  for (unsigned int f = 0; f < faces.size(); ++f)
  {
    loop.clear();
    for (const unsigned int v : faces[f])
      loop.push_back(stand_in[v]);
    add_simple_loops(result, faces.sides[f], loop);
  }
  return result;
}
} // namespace

VertexFaces without_small_features(const VertexFaces &faces,
                                   const FaceVertices &vertices,
                                   const double resolution)
{
  VertexFaces result = with_vertices_joined(faces, vertices, resolution);
  // What was joined may have made other faces narrow; often none was.
  for (std::size_t n_corners = faces.corners.size();
       result.corners.size() < n_corners;)
  {
    n_corners = result.corners.size();
    result = with_vertices_joined(result, vertices, resolution);
  }
  result = without_narrow_faces(std::move(result), vertices.places,
                                vertices.sites, resolution);
  if (result.corners.size() == faces.corners.size())
    return result;

  std::vector<unsigned int> loop;
  const StraightVertices straight(result, vertices);
  VertexFaces shortened;
  for (unsigned int f = 0; f < result.size(); ++f)
  {
    loop.clear();
    for (const unsigned int v : result[f])
      if (!straight.contains(v, resolution))
        loop.push_back(v);
    add_simple_loops(shortened, result.sides[f], loop);
  }
  return shortened;
}
} // namespace Voussoir
