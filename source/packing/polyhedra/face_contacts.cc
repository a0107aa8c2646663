// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/contacts/cell_chunks.h>
#include <voussoir/packing/polyhedra/contacts/contact_search.h>
#include <voussoir/packing/polyhedra/contacts/free_parts.h>
#include <voussoir/packing/polyhedra/face_contacts.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Voussoir
{
namespace
{
void check_contact_length(const std::string &name, const double length)
{
  if (!(std::isfinite(length) && length >= 0.))
    throw InputError(text("The ", name, " of contacts is ",
                          text_of_number(length),
                          "; it must be a finite length, not negative."));
}

void check_contact_tolerance(const ContactTolerance &tolerance)
{
  check_contact_length("tolerance", tolerance.distance);
  check_contact_length("joint width", tolerance.joint_width);
}

/** The number of cells that move. */
unsigned int n_moving_cells(const CellFaces &cells)
{
  return cells.n_cells() - cells.n_fixed;
}

/** The convex pieces of some faces, with all of their vertices. */
FreeParts whole_faces(const CellFaces &cells,
                      const std::vector<unsigned int> &faces,
                      const double tolerance)
{
  const auto chunks = in_chunks(
      faces.size(), [&](const unsigned int begin, const unsigned int end) {
        FreeParts found;
        for (unsigned int k = begin; k < end; ++k)
          for (const std::vector<unsigned int> &piece :
               convex_pieces_of_face(cells, faces[k], tolerance))
          {
            found.faces.push_back(faces[k]);
            for (const unsigned int v : piece)
              found.parts.vertices.push_back(cells.vertices[v]);
            found.parts.first.push_back(found.parts.vertices.size());
          }
        return found;
      });
  FreeParts all;
  for (const FreeParts &found : chunks)
    all.append(found);
  return all;
}

/** The shared faces of cells not both of which are fixed, in order. */
std::vector<std::array<unsigned int, 2>>
pairs_of_shared_faces(const CellFaces &cells)
{
  std::vector<std::array<unsigned int, 2>> pairs;
  pairs.reserve(cells.shared.size());
  const unsigned int first_fixed_face = cells.first_face[n_moving_cells(cells)];
  for (const auto &pair : cells.shared)
    if (std::min(pair[0], pair[1]) < first_fixed_face)
      pairs.push_back(
          {{std::min(pair[0], pair[1]), std::max(pair[0], pair[1])}});
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/** The contacts of cells whose shared faces are given. */
FaceContacts contacts_of_shared_faces(const CellFaces &cells,
                                      const double distance)
{
  const double tolerance = std::max(distance, coordinate_rounding(cells));
  FaceContacts contacts;
  std::vector<unsigned int> touching, free;
  std::vector<unsigned int> partner(cells.n_faces(), invalid_index);
  for (const auto &pair : pairs_of_shared_faces(cells))
  {
    touching.push_back(pair[0]);
    partner[pair[0]] = pair[1];
    partner[pair[1]] = pair[0];
  }
  for (unsigned int f = 0; f < cells.n_faces(); ++f)
    if (partner[f] == invalid_index)
      free.push_back(f);
  FreeParts patches = whole_faces(cells, touching, tolerance);
  for (const unsigned int face : patches.faces)
    contacts.faces.push_back({{face, partner[face]}});
  contacts.patches = std::move(patches.parts);
  FreeParts rest = whole_faces(cells, free, tolerance);
  contacts.free_faces = std::move(rest.faces);
  contacts.free_parts = std::move(rest.parts);
  return contacts;
}

/** The numbers of cells and patches of a part of a list, sorted by cells. */
ContactCount count_of(const CellFaces &cells,
                      const std::vector<std::array<unsigned int, 2>> &faces)
{
  std::vector<std::array<unsigned int, 2>> pairs;
  pairs.reserve(faces.size());
  for (const auto &pair : faces)
    if (pair[0] != pair[1])
      pairs.push_back(
          {{cells.cell_of_face(pair[0]), cells.cell_of_face(pair[1])}});
  std::sort(pairs.begin(), pairs.end());
  ContactCount count;
  count.patches = pairs.size();
  count.pairs_of_cells =
      std::unique(pairs.begin(), pairs.end()) - pairs.begin();
  return count;
}
} // namespace

FaceContacts face_contacts(const CellFaces &cells,
                           const ContactTolerance &tolerance)
{
  check_contact_tolerance(tolerance);
  if (!cells.shared.empty())
    return contacts_of_shared_faces(cells, tolerance.distance);
  const FaceGeometry geometry(cells, tolerance.distance);
  const ContactSearch search(geometry, tolerance.joint_width);
  PatchList found;
  for (const PatchList &chunk : in_chunks(
           n_moving_cells(cells), [&](unsigned int begin, unsigned int end) {
             return search.patches(begin, end);
           }))
    found.append(chunk);
  FreeParts rest = free_parts(geometry, found);
  return {std::move(found.faces), std::move(found.patches),
          std::move(rest.faces), std::move(rest.parts)};
}

ContactCount count_found(const CellFaces &cells, const FaceContacts &contacts)
{
  return count_of(cells, contacts.faces);
}

ContactCount count_contacts(const CellFaces &cells,
                            const ContactTolerance &tolerance)
{
  check_contact_tolerance(tolerance);
  if (!cells.shared.empty())
    return count_of(cells,
                    contacts_of_shared_faces(cells, tolerance.distance).faces);
  const FaceGeometry geometry(cells, tolerance.distance);
  const ContactSearch search(geometry, tolerance.joint_width);
  ContactCount all;
  for (const ContactCount &count : in_chunks(
           n_moving_cells(cells), [&](unsigned int begin, unsigned int end) {
             return count_of(cells, search.patches(begin, end).faces);
           }))
  {
    all.pairs_of_cells += count.pairs_of_cells;
    all.patches += count.patches;
  }
  return all;
}
} // namespace Voussoir
