// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/packing.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/**
 * The distance, relative to the size of its cell, that a vertex may lie outside
 * a face of a convex cell: room for the rounding of the coordinates.
 */
constexpr double tolerance_of_planes = 1e-12;

/** The volume of a cell with whose powers one can compute. */
constexpr double smallest_volume = 1e-140, largest_volume = 1e140;
} // namespace

Packing<3>::Packing(CellFaces cells) : mesh(std::move(cells))
{
  if (mesh.n_cells() == mesh.n_fixed)
    throw InputError("The packing has no block that can move.");
  const bool take_centroids = mesh.centres.empty();
  mesh.centres.resize(mesh.n_cells());
  moment_list.resize(mesh.n_cells());
  mesh.name_groups();
  for (unsigned int c = 0; c < mesh.n_cells(); ++c)
  {
    measure(c, take_centroids);
    check_shape(c);
  }
  FaceContacts contacts =
      face_contacts(mesh, {mesh.tolerance, mesh.joint_width, mesh.joins_edges});
  notice_list = mesh.notices;
  if (!contacts.notice.empty())
    notice_list.push_back(contacts.notice);
  add_interfaces(contacts, false);
  add_interfaces(contacts, true);
  add_boundary(contacts);
}

void Packing<3>::measure(const unsigned int c, const bool take_centroid)
{
  for (unsigned int f = mesh.first_face[c]; f < mesh.first_face[c + 1]; ++f)
    for (unsigned int i = 0; i < mesh.n_corners(f); ++i)
      for (unsigned int d = 0; d < 3; ++d)
        if (!std::isfinite(mesh.vertex(f, i)[d]))
          refuse(c, mesh.vertex(f, i),
                 "has a vertex whose coordinates are not finite.");
  const auto open = open_edges(mesh, c);
  if (!open.empty())
    refuse(c, mesh.vertices[open.front()[0]],
           text("is open: its edge to ",
                text_of_point(mesh.vertices[open.front()[1]]),
                " is not the side of two faces."));
  // If it is too large to compute with, the volume is not a number.
  const InvalidOperationsAllowed allowed;
  const CellMoments of_cell = moments_of(mesh, c);
  const Point<3> &place = mesh.first_face[c] < mesh.first_face[c + 1]
                              ? mesh.vertex(mesh.first_face[c], 0)
                              : Point<3>();
  if (!(of_cell.volume > 0.))
    refuse(c, place,
           text("has the volume ", text_of_number(of_cell.volume),
                "; its faces must run counterclockwise, as seen from outside, "
                "around a positive volume."));
  if (!(of_cell.volume > smallest_volume) || !(of_cell.volume < largest_volume))
    refuse(c, place,
           text("has the volume ", of_cell.volume,
                ", too large or too small to compute with; choose a unit of "
                "length in which it is between 1e-140 and 1e140."));
  moment_list[c] = of_cell;
  if (take_centroid)
    mesh.centres[c] = of_cell.centroid;
}

void Packing<3>::check_shape(const unsigned int c)
{
  const unsigned int begin = mesh.first_face[c], end = mesh.first_face[c + 1];
  const double tolerance =
      tolerance_of_planes * std::cbrt(volume(c)) + mesh.tolerance;
  bool is_convex = true, is_seen = true;
  for (unsigned int f = begin; f < end; ++f)
  {
    const PolygonMoments face = moments_of_face(mesh, f);
    if (!(face.area() > 0.))
      continue;
    const Tensor<1, 3> normal = face.normal();
    is_seen &= (face.centroid - centre(c)) * normal > 0.;
    for (unsigned int g = begin; g < end && is_convex; ++g)
      for (unsigned int i = 0; i < mesh.n_corners(g); ++i)
        is_convex &= (mesh.vertex(g, i) - face.centroid) * normal <= tolerance;
  }
  if (!is_seen && is_convex)
    refuse(c, centre(c),
           "does not have its centre inside; move the point that it is from.");
  if (!is_convex)
    concave.push_back(c);
  if (!is_seen)
    hiding.push_back(c);
}

/** Take the contacts with fixed cells, or those with other cells. */
void Packing<3>::add_interfaces(const FaceContacts &contacts,
                                const bool with_ground)
{
  const auto is_wanted = [&](const std::array<unsigned int, 2> &faces) {
    return (mesh.cell_of_face(faces[1]) >= ground()) == with_ground;
  };
  auto edge = contacts.at_edges.begin();
  const auto add_edge = [&] {
    if (is_wanted(edge->faces))
      add_interface(edge->faces,
                    dealii::ArrayView<const Point<3>>(edge->polygon),
                    &edge->normal);
    ++edge;
  };
  for (unsigned int k = 0; k < contacts.faces.size(); ++k)
  {
    while (edge != contacts.at_edges.end() && edge->faces < contacts.faces[k])
      add_edge();
    if (is_wanted(contacts.faces[k]))
      add_interface(contacts.faces[k], contacts.patches[k], nullptr);
  }
  while (edge != contacts.at_edges.end())
    add_edge();
}

/** @param normal_of_edge that of a contact at an edge; null for faces. */
void Packing<3>::add_interface(const std::array<unsigned int, 2> &faces,
                               const dealii::ArrayView<const Point<3>> polygon,
                               const Tensor<1, 3> *const normal_of_edge)
{
  const unsigned int minus = mesh.cell_of_face(faces[0]);
  const unsigned int plus = mesh.cell_of_face(faces[1]);
  const bool is_support = plus >= ground();
  const PolygonMoments of = moments_of(polygon);
  Point<3> centroid = of.centroid;
  // Symmetric, but so narrow that its triangles have few digits.
  if (normal_of_edge)
  {
    Tensor<1, 3> arms;
    for (const Point<3> &corner : polygon)
      arms += corner - polygon[0];
    centroid = polygon[0] + arms / double(polygon.size());
  }
  interface_list.push_back({minus, is_support ? ground() : plus,
                            is_support ? plus : invalid_index, faces, centroid,
                            normal_of_edge ? *normal_of_edge : of.normal(),
                            of.area(), normal_of_edge != nullptr});
  interface_polygons.add(polygon);
  support_count += is_support;
}

void Packing<3>::add_boundary(FaceContacts &contacts)
{
  part_list = std::move(contacts.free_parts);
  const auto &faces = contacts.free_faces;
  for (unsigned int k = 0, end; k < faces.size(); k = end)
  {
    Tensor<1, 3> vector_area, first;
    for (end = k; end < faces.size() && faces[end] == faces[k]; ++end)
    {
      const PolygonMoments part = moments_of(part_list[end]);
      vector_area += part.vector_area;
      first += part.area() * (part.centroid - part_list[k][0]);
    }
    const unsigned int cell = mesh.cell_of_face(faces[k]);
    const double area = vector_area.norm();
    if (cell < ground())
      boundary_list.push_back({cell, faces[k], part_list[k][0] + first / area,
                               vector_area / area, area, k, end - k});
  }
}

FaceContacts Packing<3>::contacts() const
{
  FaceContacts contacts;
  for (const Interface &interface : interface_list)
    contacts.faces.push_back(interface.faces);
  contacts.patches = interface_polygons;
  return contacts;
}

void Packing<3>::support(const std::vector<bool> &is_support)
{
  AssertDimension(is_support.size(), boundary_list.size());
  std::vector<BoundaryFace> free;
  for (unsigned int b = 0; b < boundary_list.size(); ++b)
  {
    const BoundaryFace &face = boundary_list[b];
    if (!is_support[b])
      free.push_back(face);
    else
      for (unsigned int k = 0; k < face.n_parts; ++k)
      {
        const auto part = part_list[face.first_part + k];
        const PolygonMoments of = moments_of(part);
        interface_list.push_back({face.cell,
                                  ground(),
                                  invalid_index,
                                  {{face.face, face.face}},
                                  of.centroid,
                                  of.normal(),
                                  of.area()});
        interface_polygons.add(part);
        ++support_count;
      }
  }
  boundary_list = std::move(free);
}

void Packing<3>::refuse(const unsigned int cell,
                        const Point<3> &place,
                        const std::string &fault) const
{
  std::string name = mesh.describe(cell);
  name.front() = 'C';
  throw InputError(text(name, " at ", text_of_point(place), " ", fault));
}

double Packing<3>::volume() const
{
  return std::accumulate(
      moment_list.begin(), moment_list.begin() + n_cells(), 0.,
      [](const double sum, const CellMoments &of) { return sum + of.volume; });
}

double Packing<3>::surface(const unsigned int cell) const
{
  double area = 0.;
  for (unsigned int f = mesh.first_face[cell]; f < mesh.first_face[cell + 1];
       ++f)
    area += moments_of_face(mesh, f).area();
  return area;
}

bool Packing<3>::is_seen_whole(const unsigned int cell) const
{
  return !std::binary_search(hiding.begin(), hiding.end(), cell);
}

double Packing<3>::distance(const Interface &interface) const
{
  if (interface.is_at_edge)
    return std::sqrt(interface.area);
  const unsigned int minus = interface.cell_minus, plus = interface.cell_plus;
  if (!is_seen_whole(minus) || (plus != ground() && !is_seen_whole(plus)))
    return half_distance(minus, interface) + half_distance(plus, interface);
  const Point<3> far = plus == ground() ? interface.centroid : centre(plus);
  return (far - centre(minus)) * interface.normal;
}

/** The part of d_e that lies in a cell. */
double Packing<3>::half_distance(const unsigned int cell,
                                 const Interface &interface) const
{
  if (cell == ground())
    return 0.;
  if (is_seen_whole(cell))
    return std::abs((interface.centroid - centre(cell)) * interface.normal);
  return 3. * volume(cell) / surface(cell);
}
} // namespace Voussoir
