// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/lowest_in_sets.h>
#include <voussoir/packing/polyhedra/models/block_parts.h>
#include <voussoir/packing/polyhedra/models/mend_surface.h>

#include <boost/functional/hash.hpp>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace Voussoir
{
namespace
{
using FaceNumbers = std::vector<unsigned int>;
using Parts = std::vector<FaceNumbers>;

FaceLoops loops_of_faces(const FaceLoops &faces, const FaceNumbers &part)
{
  FaceLoops loops;
  for (const unsigned int face : part)
    loops.add(faces[face]);
  return loops;
}

/** The same faces, but each set of vertices once. */
FaceLoops without_repeated_loops(const FaceLoops &faces)
{
  std::unordered_set<FaceNumbers, boost::hash<FaceNumbers>> seen;
  FaceLoops kept;
  for (unsigned int f = 0; f < faces.size(); ++f)
  {
    FaceNumbers corners(faces[f].begin(), faces[f].end());
    std::sort(corners.begin(), corners.end());
    if (seen.insert(std::move(corners)).second)
      kept.add(faces[f]);
  }
  return kept;
}

/** True if faces are one closed surface, but for those that are there twice. */
bool is_closed_but_for_copies(const FaceLoops &faces)
{
  return is_closed(faces) || is_closed(without_repeated_loops(faces));
}

/** The faces that are connected by edges. */
Parts connected_parts(const FaceLoops &faces)
{
  boost::disjoint_sets_with_storage<> sets(faces.size());
  const std::vector<FaceSide> sides = sides_of(faces);
  for (std::size_t k = 1; k < sides.size(); ++k)
    if (sides[k].is_along(sides[k - 1]))
      sets.union_set(sides[k].face, sides[k - 1].face);
  const std::vector<unsigned int> lowest = lowest_in_sets(sets, faces.size());
  std::vector<unsigned int> number(faces.size());
  Parts parts;
  for (unsigned int f = 0; f < faces.size(); ++f)
  {
    if (lowest[f] == f)
    {
      number[f] = parts.size();
      parts.emplace_back();
    }
    parts[number[lowest[f]]].push_back(f);
  }
  return parts;
}

/** The faces up to each at which all edges are closed; one part if the last is
 * not. */
Parts parts_that_close(const FaceLoops &faces, const FaceNumbers &all)
{
  using Edge = std::pair<unsigned int, unsigned int>;
  std::unordered_set<Edge, boost::hash<Edge>> open;
  Parts parts(1);
  for (const unsigned int face : all)
  {
    parts.back().push_back(face);
    const auto loop = faces[face];
    for (unsigned int i = 0; i < loop.size(); ++i)
    {
      const Edge edge = std::minmax({loop[i], loop[(i + 1) % loop.size()]});
      if (!open.insert(edge).second)
        open.erase(edge);
    }
    if (open.empty())
      parts.emplace_back();
  }
  if (!parts.back().empty())
    return {all};
  parts.pop_back();
  for (const FaceNumbers &part : parts)
    if (!is_closed(loops_of_faces(faces, part)))
      return {all};
  return parts;
}

/** The faces with one number for all vertices at one place. */
FaceLoops with_welded_numbers(const BlockMesh &block)
{
  FaceLoops faces = block.faces;
  if (!surface_of(block).is_usable())
    return faces; // it has coordinates that have no distance
  const std::vector<unsigned int> first = first_vertices_nearby(
      block.vertices, distance_of_seven_digits(block.vertices));
  for (unsigned int &corner : faces.corners)
    corner = first[corner];
  return faces;
}
} // namespace

std::vector<std::vector<unsigned int>> parts_of(const BlockMesh &block)
{
  Parts found;
  FaceNumbers rest;
  for (FaceNumbers &part : connected_parts(block.faces))
    if (is_closed_but_for_copies(loops_of_faces(block.faces, part)))
      found.push_back(std::move(part));
    else
      rest.insert(rest.end(), part.begin(), part.end());
  if (rest.empty())
    return found;

  std::sort(rest.begin(), rest.end());
  const FaceLoops welded = loops_of_faces(with_welded_numbers(block), rest);
  FaceNumbers open;
  for (const FaceNumbers &part : connected_parts(welded))
    for (FaceNumbers &closed :
         is_closed_but_for_copies(loops_of_faces(welded, part))
             ? Parts{part}
             : parts_that_close(welded, part))
    {
      const bool is_open =
          !is_closed_but_for_copies(loops_of_faces(welded, closed));
      for (unsigned int &face : closed)
        face = rest[face];
      if (is_open)
        open.insert(open.end(), closed.begin(), closed.end());
      else
        found.push_back(std::move(closed));
    }
  std::sort(open.begin(), open.end());
  if (!open.empty())
    found.push_back(std::move(open));
  std::sort(found.begin(), found.end());
  return found;
}

bool is_connected(const FaceLoops &faces)
{
  return connected_parts(faces).size() == 1;
}
} // namespace Voussoir
