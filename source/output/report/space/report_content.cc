// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/output/report/space/report_content.h>

#include <deal.II/base/exceptions.h>

#include <cmath>

namespace Voussoir
{
namespace
{
/** The largest coordinate, a length: volumes, L^3, have to be finite. */
constexpr double largest_coordinate = 1e100;

bool is_in_bounds(const dealii::Point<3> &p)
{
  for (unsigned int d = 0; d < 3; ++d)
    if (!std::isfinite(p[d]) || std::abs(p[d]) > largest_coordinate)
      return false;
  return true;
}

void check_faces(const CellFaces &cells)
{
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
    for (unsigned int f = cells.first_face[c]; f < cells.first_face[c + 1]; ++f)
      for (const unsigned int v : cells.corners(f))
      {
        if (v >= cells.vertices.size())
          throw InputError(
              text("Face ", f, " of ", cells.describe(c), " has the vertex ", v,
                   ", but there are ", cells.vertices.size(),
                   " vertices, "
                   "numbered from 0. Change the list of its vertices."));
        if (!is_in_bounds(cells.vertices[v]))
          throw InputError(text(
              "Vertex ", v, " of ", cells.describe(c), ", at ",
              text_of_point(cells.vertices[v]),
              ", has no place: its coordinates must be numbers of a size of ",
              largest_coordinate, " at most. Change them."));
      }
}

void check_contacts(const CellFaces &cells, const FaceContacts &contacts)
{
  if (contacts.patches.size() != contacts.faces.size())
    throw InputError(text("There are ", contacts.faces.size(),
                          " pairs of faces that touch, but ",
                          contacts.patches.size(),
                          " polygons in which they do. Give one for each."));
  for (unsigned int j = 0; j < contacts.faces.size(); ++j)
  {
    for (const unsigned int f : contacts.faces[j])
      if (f >= cells.n_faces())
        throw InputError(text("Contact ", j, " is one of face ", f,
                              ", but there are ",
                              counted(cells.n_faces(), "face"),
                              ", numbered from 0. Change the pair."));
    for (const dealii::Point<3> &p : contacts.patches[j])
      if (!is_in_bounds(p))
        throw InputError(text(
            "A corner of contact ", j, ", at ", text_of_point(p),
            ", has no place: its coordinates must be numbers of a size of ",
            largest_coordinate, " at most. Change them."));
  }
}

void check_fields(const std::vector<SpaceField> &fields,
                  const std::size_t n,
                  const std::string &things)
{
  for (const SpaceField &field : fields)
    if (field.values.size() != n)
      throw InputError(text("The field '", field.name, "' has ",
                            counted(field.values.size(), "value"), " for ",
                            counted(n, things), ". Give one for each."));
}
} // namespace

void check_content(const SpaceReport &report)
{
  AssertThrow(report.cells != nullptr,
              dealii::ExcMessage("SpaceReport::cells is not set."));
  check_faces(*report.cells);
  if (report.contacts)
    check_contacts(*report.cells, *report.contacts);
  check_fields(report.cell_fields, report.cells->n_cells(), "block");
  check_fields(report.contact_fields,
               report.contacts ? report.contacts->faces.size() : 0, "joint");
}
} // namespace Voussoir
