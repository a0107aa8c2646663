// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/chunks.h>
#include <voussoir/packing/polyhedra/contacts/free_parts.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
/** The patches of each face, in ascending order. */
class PatchesOfFaces
{
public:
  PatchesOfFaces(const unsigned int n_faces, const PatchList &list)
      : first(n_faces + 1), numbers(2 * list.faces.size())
  {
    for (const auto &pair : list.faces)
      for (const unsigned int face : pair)
        ++first[face + 1];
    for (unsigned int f = 0; f < n_faces; ++f)
      first[f + 1] += first[f];
    std::vector<unsigned int> next(first.begin(), first.end() - 1);
    for (unsigned int k = 0; k < list.faces.size(); ++k)
      for (const unsigned int face : list.faces[k])
        numbers[next[face]++] = k;
  }

  dealii::ArrayView<const unsigned int> of(const unsigned int face) const
  {
    return {numbers.data() + first[face], first[face + 1] - first[face]};
  }

private:
  std::vector<unsigned int> first, numbers;
};

/** A patch in the coordinates of one of its faces, out of whose cell they look.
 */
ConvexRing ring_of_patch(const PatchList &list,
                         const unsigned int patch,
                         const unsigned int face,
                         const PlaneFrame &frame)
{
  ConvexRing ring;
  for (const dealii::Point<3> &place : list.patches[patch])
    ring.push_back({frame.project(place), invalid_index});
  if (list.faces[patch][0] != face)
    std::reverse(ring.begin(), ring.end());
  return ring;
}

/** The rest of a face without some patches. */
ConvexRings rest_of_face(const FaceGeometry &geometry,
                         const PatchList &list,
                         const unsigned int face,
                         const dealii::ArrayView<const unsigned int> &patches,
                         const PlaneFrame &frame)
{
  ConvexRings rest;
  for (unsigned int p = geometry.pieces.first_of_face(face);
       p < geometry.pieces.first_of_face(face + 1); ++p)
  {
    const ConvexRing ring = geometry.pieces.ring(p, frame);
    rest.push_back(ring);
  }
  for (const unsigned int patch : patches)
    rest = without(rest, ring_of_patch(list, patch, face, frame),
                   geometry.tolerance);
  return rest;
}
} // namespace

void FreeParts::append(const FreeParts &other)
{
  faces.insert(faces.end(), other.faces.begin(), other.faces.end());
  parts.append(other.parts);
}

FreeParts free_parts(const FaceGeometry &geometry, const PatchList &patches)
{
  const CellFaces &cells = geometry.cells;
  const PatchesOfFaces of_faces(cells.n_faces(), patches);
  const auto chunks = in_chunks(cells.n_faces(), [&](const unsigned int begin,
                                                     const unsigned int end) {
    FreeParts found;
    for (unsigned int f = begin; f < end; ++f)
    {
      if (geometry.pieces.first_of_face(f) ==
          geometry.pieces.first_of_face(f + 1))
        continue;
      const PlaneFrame frame(cells.vertex(f, 0), geometry.planes[f].normal);
      const double height = frame.height(geometry.planes[f].centre);
      for (const ConvexRing &ring :
           rest_of_face(geometry, patches, f, of_faces.of(f), frame))
      {
        found.faces.push_back(f);
        for (const RingCorner &corner : ring)
          found.parts.vertices.push_back(corner.vertex == invalid_index
                                             ? frame.place(corner.at, height)
                                             : cells.vertices[corner.vertex]);
        found.parts.first.push_back(found.parts.vertices.size());
      }
    }
    return found;
  });
  FreeParts all;
  for (const FreeParts &found : chunks)
    all.append(found);
  return all;
}
} // namespace Voussoir
