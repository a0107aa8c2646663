// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/contacts/contact_search.h>
#include <voussoir/packing/polyhedra/contacts/joint_sight.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
/**
 * The share of what two faces have in common that lies within the tolerance, at
 * least, of a contact between them. With less they meet along an edge: near
 * that all faces are within any tolerance of each other.
 */
constexpr double least_share_of_wedge = 0.1;
} // namespace

void PatchList::append(const PatchList &other)
{
  faces.insert(faces.end(), other.faces.begin(), other.faces.end());
  patches.append(other.patches);
}

ContactSearch::ContactSearch(const FaceGeometry &geometry,
                             const double joint_width)
    : geometry(geometry), range{-geometry.tolerance,
                                joint_width + geometry.tolerance}
{}

PatchList ContactSearch::patches(const unsigned int begin,
                                 const unsigned int end) const
{
  PatchList list;
  for (unsigned int cell = begin; cell < end; ++cell)
    for (const Pair &faces : candidates(cell))
      add_patches(list, faces);
  return list;
}

std::vector<unsigned int> ContactSearch::faces_near(const unsigned int cell,
                                                    const SpaceBox &box) const
{
  std::vector<unsigned int> near;
  for (unsigned int f = geometry.cells.first_face[cell];
       f < geometry.cells.first_face[cell + 1]; ++f)
    if (common_extent(geometry.boxes.of_face(f), box) >= -range.greatest)
      near.push_back(f);
  return near;
}

std::vector<ContactSearch::Pair>
ContactSearch::candidates(const unsigned int cell) const
{
  std::vector<Pair> pairs;
  for (const unsigned int other :
       geometry.boxes.higher_neighbours(cell, range.greatest))
  {
    const std::vector<unsigned int> theirs =
        faces_near(other, geometry.boxes.of_cell(cell));
    for (const unsigned int f : faces_near(cell, geometry.boxes.of_cell(other)))
      for (const unsigned int g : theirs)
        if (may_touch(geometry.planes[f], geometry.planes[g], range))
          pairs.push_back({{f, g}});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

ConvexRings ContactSearch::touching_parts(const FacePair &pair) const
{
  const auto [f, g] = pair.numbers();
  const FacePieces &pieces = geometry.pieces;
  ConvexRings parts;
  double in_common = 0., touching = 0.;
  for (unsigned int p = pieces.first_of_face(f);
       p < pieces.first_of_face(f + 1); ++p)
    for (unsigned int q = pieces.first_of_face(g);
         q < pieces.first_of_face(g + 1); ++q)
    {
      const ConvexRing common = pair.common_part({{p, q}});
      const ConvexRing part = pair.part_within(common, range);
      in_common += area(common);
      touching += area(part);
      if (width(part) > geometry.tolerance)
        parts.push_back(part);
    }
  if (!(touching >= least_share_of_wedge * in_common))
    parts.clear();
  return parts;
}

void ContactSearch::add_patches(PatchList &list, const Pair &faces) const
{
  const FacePair pair(geometry, faces);
  const auto add = [&](const ConvexRing &ring) {
    list.faces.push_back(faces);
    for (const RingCorner &corner : ring)
      list.patches.vertices.push_back(pair.place(corner));
    list.patches.first.push_back(list.patches.vertices.size());
  };
  for (const ConvexRing &ring : touching_parts(pair))
  {
    const bool is_open =
        std::any_of(ring.begin(), ring.end(), [&](const RingCorner &corner) {
          return pair.gap(corner.at) > geometry.tolerance;
        });
    if (!is_open)
      add(ring);
    else
      for (const ConvexRing &part : parts_in_sight(geometry, pair, ring))
        add(part);
  }
}
} // namespace Voussoir
