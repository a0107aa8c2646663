// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/voronoi/face_cutter.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace Voussoir
{
namespace
{
VertexName name_of_four(const std::array<unsigned int, 2> &sides,
                        const unsigned int a,
                        const unsigned int b)
{
  VertexName name = {{sides[0], sides[1], a, b}};
  std::sort(name.begin(), name.end());
  return name;
}
} // namespace

SiteFaces<CutCorner> FaceCutter::cut(const SiteFaces<CutCorner> &faces,
                                     const unsigned int k)
{
  const unsigned int site = sites.plane_site(k);
  crossings.clear();
  segments.clear();
  result = {};
  for (unsigned int f = 0; f < faces.size(); ++f)
  {
    find_what_is_beyond(faces, f, k);
    const auto n_beyond = std::count(is_beyond.begin(), is_beyond.end(), true);
    if (n_beyond == 0)
    {
      const auto corners = faces[f];
      result.corners.insert(result.corners.end(), corners.begin(),
                            corners.end());
      result.end_face(faces.sides[f]);
    }
    else if (static_cast<std::size_t>(n_beyond) < is_beyond.size())
      cut_face(faces, f, site);
  }
  add_faces_in_plane(site);
  return std::move(result);
}

void FaceCutter::find_what_is_beyond(const SiteFaces<CutCorner> &faces,
                                     const unsigned int face,
                                     const unsigned int k)
{
  const auto corners = faces[face];
  is_beyond.resize(corners.size());
  for (unsigned int i = 0; i < corners.size(); ++i)
  {
    const CutCorner &before =
        corners[(i + corners.size() - 1) % corners.size()];
    is_beyond[i] =
        sites.is_beyond(name_of_four(faces.sides[face], before.beyond_edge,
                                     corners[i].beyond_edge),
                        places[corners[i].vertex], k);
  }
}

/** Keep the corners of a face that are not beyond the plane. */
void FaceCutter::cut_face(const SiteFaces<CutCorner> &faces,
                          const unsigned int face,
                          const unsigned int site)
{
  const auto corners = faces[face];
  const auto &sides = faces.sides[face];
  const unsigned int n = corners.size();
  unsigned int begin = 0; // the first corner inside
  while (is_beyond[begin] || !is_beyond[(begin + n - 1) % n])
    ++begin;
  unsigned int end = begin + 1; // the first one beyond
  while (!is_beyond[end % n])
    ++end;

  const unsigned int edge_in = corners[(begin + n - 1) % n].beyond_edge;
  const unsigned int edge_out = corners[(end - 1) % n].beyond_edge;
  const unsigned int in = crossing(sides, edge_in, site);
  const unsigned int out = crossing(sides, edge_out, site);
  result.corners.push_back({in, edge_in});
  for (unsigned int i = begin; i < end; ++i)
    result.corners.push_back(corners[i % n]);
  result.corners.push_back({out, site});
  result.end_face(sides);

  segments.push_back({sides[0], in, out, sides[1]});
  if (sides[1] < sites.n_generators())
    segments.push_back({sides[1], out, in, sides[0]});
}

/** The vertex where an edge of a face crosses the plane. */
unsigned int FaceCutter::crossing(const std::array<unsigned int, 2> &sides,
                                  const unsigned int beyond_edge,
                                  const unsigned int site)
{
  const VertexName name = name_of_four(sides, beyond_edge, site);
  const auto [known, is_new] = crossings.try_emplace(name, places.size());
  if (is_new)
  {
    places.push_back(sites.place(name));
    n_planes_of_made.push_back(sites.n_planes(name));
  }
  return known->second;
}

/** Link the segments of each cell to a face. */
void FaceCutter::add_faces_in_plane(const unsigned int site)
{
  std::sort(segments.begin(), segments.end(),
            [](const Segment &a, const Segment &b) {
              return std::tie(a.cell, a.from) < std::tie(b.cell, b.from);
            });
  for (auto begin = segments.begin(), end = begin; begin != segments.end();
       begin = end)
  {
    const unsigned int cell = begin->cell;
    end = std::find_if(begin, segments.end(),
                       [&](const Segment &s) { return s.cell != cell; });
    auto segment = begin;
    for (auto i = begin; i != end; ++i)
    {
      result.corners.push_back({segment->from, segment->beyond_edge});
      segment = std::lower_bound(
          begin, end, segment->to,
          [](const Segment &s, const unsigned int v) { return s.from < v; });
      AssertThrow(segment != end, dealii::ExcInternalError());
    }
    AssertThrow(segment == begin, dealii::ExcInternalError());
    result.end_face({{cell, site}});
  }
}
} // namespace Voussoir
