// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/models/mend_surface.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;
using DefectKind = ModelDefect::Kind;

namespace
{
constexpr unsigned int no_vertex = std::numeric_limits<unsigned int>::max();

/**
 * The cosine of the largest angle between a face and the plane that it is
 * joined to: beyond 60 degrees it is another side of the block, even if it is
 * no wider than the tolerance.
 */
constexpr double least_cosine_of_joined = 0.5;

/**
 * The distance from the plane of all over that at which a face is joined: with
 * more the plane has drifted along a curved surface.
 */
constexpr double largest_drift = 2.;

/** Joins the faces of one surface; one object, used once. */
class FaceJoining
{
public:
  FaceJoining(const Surface &surface, const double distance)
      : surface(surface), distance(distance),
        next(surface.vertices.size(), no_vertex)
  {
    for (unsigned int f = 0; f < surface.faces.size(); ++f)
    {
      planes.push_back(plane_of(surface, f));
      areas.push_back(planes[f].vector_area.norm());
    }
    find_neighbours();
  }

  /** True if a face lies in the plane of one beside it. */
  bool has_coplanar_neighbours() const
  {
    for (unsigned int f = 0; f < surface.faces.size(); ++f)
      for (const unsigned int g : neighbours[f])
        if (areas[f] > 0. && lies_in(g, planes[f]))
          return true;
    return false;
  }

  /** For each face the loop of all joined to it; empty for the others. */
  std::vector<std::vector<unsigned int>> join()
  {
    const unsigned int n = surface.faces.size();
    std::vector<std::vector<unsigned int>> loops(n);
    is_taken.assign(n, false);
    std::vector<unsigned int> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](const unsigned int f, const unsigned int g) {
                       return areas[f] > areas[g];
                     });
    for (const unsigned int seed : order)
    {
      if (is_taken[seed])
        continue;
      std::vector<unsigned int> region = grow(seed, true);
      if (deviation_of_loop(region) > largest_drift * distance)
      {
        give_back(region);
        region = grow(seed, false);
      }
      const unsigned int lowest =
          *std::min_element(region.begin(), region.end());
      loops[lowest] = take_loop(lowest, region);
    }
    return loops;
  }

private:
  void find_neighbours()
  {
    neighbours.resize(surface.faces.size());
    const std::vector<FaceSide> sides = sides_of(surface.faces);
    for (std::size_t k = 0; k + 1 < sides.size(); k += 2)
    {
      neighbours[sides[k].face].push_back(sides[k + 1].face);
      neighbours[sides[k + 1].face].push_back(sides[k].face);
    }
  }

  bool lies_in(const unsigned int face, const SurfacePlane &plane) const
  {
    const Tensor<1, 3> normal = plane.vector_area / plane.vector_area.norm();
    double length = 0.;
    const auto loop = surface.faces[face];
    for (const unsigned int v : loop)
    {
      if (std::abs(normal * (surface.vertices[v] - plane.place)) > distance)
        return false;
      length = std::max(
          length, surface.vertices[v].distance(surface.vertices[loop[0]]));
    }
    const bool is_sliver = areas[face] <= distance * length;
    return is_sliver || normal * planes[face].vector_area >=
                            least_cosine_of_joined * areas[face];
  }

  bool is_simple(const unsigned int face) const
  {
    std::vector<unsigned int> loop(surface.faces[face].begin(),
                                   surface.faces[face].end());
    std::sort(loop.begin(), loop.end());
    return std::adjacent_find(loop.begin(), loop.end()) == loop.end();
  }

  /** The faces in the plane of a face; their outline is in next. */
  std::vector<unsigned int> grow(const unsigned int seed, const bool may_drift)
  {
    std::vector<unsigned int> region = {seed};
    is_taken[seed] = true;
    const auto loop = surface.faces[seed];
    n_sides = loop.size();
    for (unsigned int i = 0; i < loop.size(); ++i)
      next[loop[i]] = loop[(i + 1) % loop.size()];
    if (!(areas[seed] > 0.) || !is_simple(seed))
      return region;
    SurfacePlane plane = planes[seed];
    std::vector<unsigned int> front = neighbours[seed], later;
    for (bool goes_on = true; goes_on; std::swap(front, later))
    {
      goes_on = false;
      later.clear();
      for (const unsigned int face : front)
      {
        if (is_taken[face])
          continue;
        if (!lies_in(face, plane) || !is_simple(face) || !extend(face))
        {
          later.push_back(face);
          continue;
        }
        goes_on = is_taken[face] = true;
        region.push_back(face);
        later.insert(later.end(), neighbours[face].begin(),
                     neighbours[face].end());
        if (may_drift)
          plane = common_plane(plane, planes[face]);
      }
      std::sort(later.begin(), later.end());
      later.erase(std::unique(later.begin(), later.end()), later.end());
    }
    return region;
  }

  /** The plane of two, by their areas. */
  static SurfacePlane common_plane(const SurfacePlane &a, const SurfacePlane &b)
  {
    SurfacePlane plane;
    plane.vector_area = a.vector_area + b.vector_area;
    const double area_a = a.vector_area.norm(), area_b = b.vector_area.norm();
    plane.place = a.place + area_b / (area_a + area_b) * (b.place - a.place);
    return plane.vector_area.norm() > 0. ? plane : a;
  }

  /**
   * Add a face to the outline if it then still is one loop that touches itself
   * nowhere: if the two have one chain of sides, and no other vertex, in
   * common.
   */
  bool extend(const unsigned int face)
  {
    const auto loop = surface.faces[face];
    const unsigned int n = loop.size();
    const auto is_shared = [&](const unsigned int i) {
      return next[loop[(i + 1) % n]] == loop[i % n];
    };
    unsigned int n_shared = 0, n_chains = 0, start = 0;
    for (unsigned int i = 0; i < n; ++i)
      if (is_shared(i))
      {
        ++n_shared;
        if (!is_shared(i + n - 1))
        {
          ++n_chains;
          start = i;
        }
      }
    if (n_chains != 1 || n_shared == n_sides || n + n_sides < 3 + 2 * n_shared)
      return false;
    for (unsigned int i = start + n_shared + 1; i < start + n; ++i)
      if (next[loop[i % n]] != no_vertex)
        return false;
    for (unsigned int i = start + 1; i < start + n_shared; ++i)
      next[loop[i % n]] = no_vertex;
    for (unsigned int i = start + n_shared; i < start + n; ++i)
      next[loop[i % n]] = loop[(i + 1) % n];
    n_sides += n;
    n_sides -= 2 * n_shared;
    return true;
  }

  /** How far the vertices of the outline are from its plane; a length. */
  double deviation_of_loop(const std::vector<unsigned int> &region) const
  {
    if (region.size() == 1)
      return 0.;
    Surface outline;
    const unsigned int start = start_of_loop(region[0], region);
    for (unsigned int v = start;;)
    {
      outline.vertices.push_back(surface.vertices[v]);
      v = next[v];
      if (v == start)
        break;
    }
    std::vector<unsigned int> loop(outline.vertices.size());
    std::iota(loop.begin(), loop.end(), 0);
    outline.faces.add(loop);
    return plane_of(outline, 0).deviation;
  }

  /** A vertex of the outline, of a face if it has one there. */
  unsigned int start_of_loop(const unsigned int face,
                             const std::vector<unsigned int> &region) const
  {
    for (const unsigned int v : surface.faces[face])
      if (next[v] != no_vertex)
        return v;
    for (const unsigned int f : region)
      for (const unsigned int v : surface.faces[f])
        if (next[v] != no_vertex)
          return v;
    return no_vertex;
  }

  void give_back(const std::vector<unsigned int> &region)
  {
    for (const unsigned int f : region)
    {
      is_taken[f] = false;
      for (const unsigned int v : surface.faces[f])
        next[v] = no_vertex;
    }
  }

  /** The outline, from a vertex of a face on; next has none afterwards. */
  std::vector<unsigned int> take_loop(const unsigned int face,
                                      const std::vector<unsigned int> &region)
  {
    std::vector<unsigned int> loop;
    if (region.size() == 1)
    {
      // Nothing was joined, and the loop may touch itself.
      const auto own = surface.faces[face];
      for (const unsigned int v : own)
        next[v] = no_vertex;
      return {own.begin(), own.end()};
    }
    for (unsigned int v = start_of_loop(face, region); next[v] != no_vertex;)
    {
      loop.push_back(v);
      v = std::exchange(next[v], no_vertex);
    }
    return loop;
  }

  const Surface &surface;
  const double distance;
  std::vector<SurfacePlane> planes;
  std::vector<double> areas;
  std::vector<std::vector<unsigned int>> neighbours;
  std::vector<bool> is_taken;
  std::vector<unsigned int> next; // vertex of the outline; of others, none
  unsigned int n_sides = 0;       // of the outline
};
} // namespace

void join_coplanar_faces(MendedSurface &mended, const double distance)
{
  Surface &surface = mended.surface;
  FaceJoining joining(surface, distance);
  if (!joining.has_coplanar_neighbours())
    return;
  const std::vector<std::vector<unsigned int>> loops = joining.join();
  Surface joined;
  ModelDefect defect = {DefectKind::joined_face};
  defect.count = 0;
  for (unsigned int f = 0; f < loops.size(); ++f)
    if (!loops[f].empty())
      joined.add(loops[f], surface.source[f]);
    else if (defect.count++ == 0)
    {
      defect.face = surface.source[f];
      defect.place = surface.vertices[surface.faces[f][0]];
    }
  if (defect.count == 0)
    return;
  joined.vertices = std::move(surface.vertices);
  surface = std::move(joined);
  mended.defects.push_back(defect);
}
} // namespace Voussoir
