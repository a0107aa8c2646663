// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/chunks.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/contacts/contact_search.h>
#include <voussoir/packing/polyhedra/contacts/edge_search.h>
#include <voussoir/packing/polyhedra/contacts/free_parts.h>
#include <voussoir/packing/polyhedra/face_contacts.h>

#include <algorithm>
#include <cmath>
#include <optional>
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

/** Finds the contacts of cells by the places of their faces. */
class SearchByPlace
{
public:
  SearchByPlace(const CellFaces &cells, const ContactTolerance &tolerance)
      : geometry(cells, tolerance.distance),
        of_faces(geometry, tolerance.joint_width)
  {
    if (tolerance.joins_edges && tolerance.joint_width == 0.)
      of_edges.emplace(geometry);
  }

  /** Those of some cells with all cells of higher numbers. */
  struct Found
  {
    PatchList patches;
    EdgeContacts at_edges;
  };
  Found find(const unsigned int begin, const unsigned int end) const
  {
    Found found = {of_faces.patches(begin, end), {}};
    if (of_edges)
      found.at_edges = of_edges->find(begin, end, found.patches);
    return found;
  }

  const FaceGeometry geometry;

private:
  const ContactSearch of_faces;
  std::optional<EdgeSearch> of_edges;
};

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
  const SearchByPlace search(cells, tolerance);
  PatchList patches;
  EdgeContacts at_edges;
  for (SearchByPlace::Found &found : in_chunks(
           n_moving_cells(cells), [&](unsigned int begin, unsigned int end) {
             return search.find(begin, end);
           }))
  {
    patches.append(found.patches);
    at_edges.append(std::move(found.at_edges));
  }
  FreeParts rest = free_parts(search.geometry, patches);
  std::string notice = notice_of(cells, at_edges);
  return {std::move(patches.faces),   std::move(patches.patches),
          std::move(at_edges.joints), std::move(notice),
          std::move(rest.faces),      std::move(rest.parts)};
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
  const SearchByPlace search(cells, tolerance);
  ContactCount all;
  for (const ContactCount &count : in_chunks(
           n_moving_cells(cells), [&](unsigned int begin, unsigned int end) {
             SearchByPlace::Found found = search.find(begin, end);
             std::vector<std::array<unsigned int, 2>> &faces =
                 found.patches.faces;
             for (const EdgeContact &joint : found.at_edges.joints)
               faces.push_back(joint.faces);
             return count_of(cells, faces);
           }))
  {
    all.pairs_of_cells += count.pairs_of_cells;
    all.patches += count.patches;
  }
  return all;
}
} // namespace Voussoir
