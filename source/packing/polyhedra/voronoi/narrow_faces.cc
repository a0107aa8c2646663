// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/voronoi/narrow_faces.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace Voussoir
{
using dealii::Point;

NarrowLoop::NarrowLoop(const dealii::ArrayView<const unsigned int> corners,
                       const std::vector<Point<3>> &places)
    : corners(corners), places(places)
{
  const auto farthest_from = [&](const Point<3> &from) {
    Point<3> farthest = from;
    double largest = 0.;
    for (const unsigned int v : corners)
    {
      const double square = places[v].distance_square(from);
      if (square > largest)
      {
        largest = square;
        farthest = places[v];
      }
    }
    return farthest;
  };
  origin = farthest_from(places[corners[0]]);
  chord = farthest_from(origin) - origin;
}

bool NarrowLoop::is_narrower_than(const double width,
                                  const dealii::Tensor<1, 3> &normal) const
{
  const Point<3> &first = places[corners[0]];
  double twice_area = 0.;
  for (unsigned int i = 1; i + 1 < corners.size(); ++i)
    twice_area += normal * cross_product_3d(places[corners[i]] - first,
                                            places[corners[i + 1]] - first);
  return twice_area <= 2. * width * chord.norm();
}

std::vector<unsigned int> NarrowLoop::along_chord() const
{
  std::vector<std::pair<double, unsigned int>> sorted;
  for (const unsigned int v : corners)
    sorted.emplace_back(chord * (places[v] - origin), v);
  std::sort(sorted.begin(), sorted.end());
  std::vector<unsigned int> vertices;
  for (const auto &[place, v] : sorted)
    if (vertices.empty() || vertices.back() != v)
      vertices.push_back(v);
  return vertices;
}

void add_simple_loops(SiteFaces<unsigned int> &faces,
                      const std::array<unsigned int, 2> &sides,
                      const std::vector<unsigned int> &loop)
{
  // The part so far is behind the last face of the list.
  auto &corners = faces.corners;
  std::vector<unsigned int> part;
  const auto add = [&] { faces.end_face(sides); };
  for (const unsigned int v : loop)
  {
    const auto begin = corners.begin() + faces.first.back();
    const auto visited = std::find(begin, corners.end(), v);
    if (visited == corners.end())
    {
      corners.push_back(v);
      continue;
    }
    // Put the loop from there to here in front of what comes before it.
    if (corners.end() - visited < 3)
    {
      corners.erase(visited + 1, corners.end());
      continue;
    }
    part.assign(begin, visited + 1);
    corners.erase(begin, visited);
    add();
    corners.insert(corners.end(), part.begin(), part.end());
  }
  if (corners.size() - faces.first.back() < 3)
    faces.drop_face();
  else
    add();
}

namespace
{
/** Folds narrow faces; one object, used once. */
class NarrowFaceFolder
{
public:
  NarrowFaceFolder(const SiteFaces<unsigned int> &faces,
                   const std::vector<Point<3>> &places,
                   const VoronoiSites &sites,
                   const double resolution)
      : faces(faces), places(places)
  {
    for (unsigned int f = 0; f < faces.size(); ++f)
      if (NarrowLoop(faces[f], places)
              .is_narrower_than(resolution, sites.direction(faces.sides[f])))
        narrow.push_back(f);
  }

  bool has_none() const { return narrow.empty(); }

  SiteFaces<unsigned int> fold()
  {
    collect_faces_around();
    for (const unsigned int f : narrow)
      fold(f);
    SiteFaces<unsigned int> result;
    std::vector<unsigned int> loop;
    for (unsigned int f = 0; f < faces.size(); ++f)
    {
      const auto changed = loops.find(f);
      if (changed == loops.end())
        loop.assign(faces[f].begin(), faces[f].end());
      add_simple_loops(result, faces.sides[f],
                       changed == loops.end() ? loop : changed->second);
    }
    return result;
  }

private:
  /** Those that may have an edge of a narrow face. */
  void collect_faces_around()
  {
    for (const unsigned int f : narrow)
      for (const unsigned int v : faces[f])
        faces_at[v];
    for (unsigned int f = 0; f < faces.size(); ++f)
    {
      const auto corners = faces[f];
      const auto n_common = std::count_if(
          corners.begin(), corners.end(),
          [&](const unsigned int v) { return faces_at.count(v); });
      if (n_common < 2)
        continue;
      loops[f].assign(corners.begin(), corners.end());
      for (const unsigned int v : corners)
        if (faces_at.count(v))
          faces_at[v].insert(f);
    }
  }

  /** Replace the edges of a narrow face by steps along its chord; drop it. */
  void fold(const unsigned int face)
  {
    const std::vector<unsigned int> loop = loops.at(face);
    const std::vector<unsigned int> along =
        NarrowLoop({loop.data(), loop.size()}, places).along_chord();
    loops[face].clear();
    for (unsigned int i = 0; i < loop.size(); ++i)
    {
      auto from = std::find(along.begin(), along.end(), loop[i]);
      auto to =
          std::find(along.begin(), along.end(), loop[(i + 1) % loop.size()]);
      if (to < from)
        std::swap(from, to);
      if (to - from > 1)
        subdivide({from, to + 1});
    }
  }

  /** Put the inner vertices of a @p path on the edge between its ends. */
  void subdivide(std::vector<unsigned int> path)
  {
    const std::set<unsigned int> candidates = faces_at[path.front()];
    for (const unsigned int f : candidates)
    {
      std::vector<unsigned int> &loop = loops[f];
      for (unsigned int i = 0; i < loop.size(); ++i)
      {
        const unsigned int next = loop[(i + 1) % loop.size()];
        if (loop[i] == path.back() && next == path.front())
          std::reverse(path.begin(), path.end());
        if (loop[i] != path.front() || next != path.back())
          continue;
        loop.insert(loop.begin() + i + 1, path.begin() + 1, path.end() - 1);
        i += path.size() - 2;
        for (const unsigned int v : path)
          faces_at[v].insert(f);
      }
    }
  }

  const SiteFaces<unsigned int> &faces;
  const std::vector<Point<3>> &places;
  /** The faces that go. */
  std::vector<unsigned int> narrow;
  /** What has become of the faces around. */
  std::map<unsigned int, std::vector<unsigned int>> loops;
  /** Those among them that have a vertex of a narrow face. */
  std::map<unsigned int, std::set<unsigned int>> faces_at;
};
} // namespace

SiteFaces<unsigned int>
without_narrow_faces(SiteFaces<unsigned int> faces,
                     const std::vector<Point<3>> &places,
                     const VoronoiSites &sites,
                     const double resolution)
{
  // Loops that come apart may leave narrow parts, which are fewer each time.
  for (unsigned int n_before = faces.size() + 1; faces.size() < n_before;)
  {
    n_before = faces.size();
    NarrowFaceFolder folder(faces, places, sites, resolution);
    if (folder.has_none())
      break;
    faces = folder.fold();
  }
  return faces;
}
} // namespace Voussoir
