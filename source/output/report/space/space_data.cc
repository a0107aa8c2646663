// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/report/space/space_data.h>
#include <voussoir/output/report/space/space_picture.h>
#include <voussoir/packing/polyhedra/cell_moments.h>
#include <voussoir/packing/polyhedra/face_triangles.h>

#include <deal.II/base/utilities.h>

#include <boost/endian/conversion.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace Voussoir
{
namespace
{
using dealii::Point;
using Json = nlohmann::ordered_json;

/** The number of the colour of a value that is missing. */
constexpr std::uint8_t no_colour = 255;

/** A list of numbers as base64 of its bytes. */
template <typename Number>
std::string base64(const std::vector<Number> &numbers)
{
  std::vector<unsigned char> bytes(sizeof(Number) * numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    boost::endian::endian_store<Number, sizeof(Number),
                                boost::endian::order::little>(
        bytes.data() + sizeof(Number) * i, numbers[i]);
  return dealii::Utilities::encode_base64(bytes);
}

/** Places as the page has them: from the middle of all, and of the size one. */
class PlaceList
{
public:
  explicit PlaceList(const dealii::BoundingBox<3> &box) : centre(box.center())
  {
    double half = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      half = std::max(half, 0.5 * box.side_length(d));
    scale = half > 0. ? half : 1.;
  }

  /** Add what places it has to @p json, under a name. */
  void write(Json &json,
             const std::string &name,
             const std::vector<Point<3>> &points) const
  {
    std::vector<float> numbers;
    numbers.reserve(3 * points.size());
    for (const Point<3> &p : points)
      for (unsigned int d = 0; d < 3; ++d)
        numbers.push_back((p[d] - centre[d]) / scale);
    json[name] = base64(numbers);
  }

  /** The place that is stored as zero, a length. */
  Point<3> centre;
  /** The length that is stored as one. */
  double scale;
};

/** The differences of starts, and the end, as uint32. */
std::vector<std::uint32_t> sizes_of(const std::vector<unsigned int> &starts)
{
  std::vector<std::uint32_t> sizes;
  for (std::size_t i = 0; i + 1 < starts.size(); ++i)
    sizes.push_back(starts[i + 1] - starts[i]);
  return sizes;
}

std::vector<std::uint32_t> as_uint32(const std::vector<unsigned int> &numbers)
{
  return {numbers.begin(), numbers.end()};
}

/** The vertices that a face has; others have any place, or none. */
std::vector<Point<3>> used_vertices(const CellFaces &cells)
{
  if (cells.loops.empty())
    return {};
  std::vector<Point<3>> vertices(cells.vertices.size(),
                                 cells.vertices[cells.loops[0]]);
  for (const unsigned int v : cells.loops)
    vertices[v] = cells.vertices[v];
  return vertices;
}

void write_faces(Json &json, const CellFaces &cells)
{
  json["cell_faces"] = base64(sizes_of(cells.first_face));
  json["face_sizes"] = base64(sizes_of(cells.first_corner));
  json["corners"] = base64(as_uint32(cells.loops));
  std::vector<std::uint32_t> cut_faces, cut_triangles;
  for (unsigned int f = 0; f < cells.n_faces(); ++f)
    if (!is_convex_face(cells, f))
    {
      cut_faces.push_back(f);
      for (const auto &triangle : triangles_of(cells, f))
        for (const unsigned int i : triangle)
          cut_triangles.push_back(cells.corners(f)[i]);
    }
  json["cut_faces"] = base64(cut_faces);
  json["cut_triangles"] = base64(cut_triangles);
}

void write_cells(Json &json, const CellFaces &cells)
{
  std::vector<double> volumes, centroids;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
  {
    const CellMoments moments = moments_of(cells, c);
    volumes.push_back(moments.volume);
    for (unsigned int d = 0; d < 3; ++d)
      centroids.push_back(moments.centroid[d]);
  }
  json["volumes"] = base64(volumes);
  json["centroids"] = base64(centroids);
  json["names"] = cells.group_names;
  json["groups"] = base64(as_uint32(cells.group));
  json["file"] = cells.file;
  json["record_name"] = cells.record_name;
  json["records"] = base64(as_uint32(cells.records));
}

void write_joints(Json &json,
                  const CellFaces &cells,
                  const FaceContacts &contacts,
                  const PlaceList &places)
{
  std::vector<std::uint32_t> pairs;
  std::vector<double> areas;
  for (unsigned int j = 0; j < contacts.faces.size(); ++j)
  {
    for (const unsigned int f : contacts.faces[j])
      pairs.push_back(cells.cell_of_face(f));
    areas.push_back(moments_of(contacts.patches[j]).area());
  }
  json["joint_cells"] = base64(pairs);
  json["joint_sizes"] = base64(sizes_of(contacts.patches.first));
  places.write(json, "joint_vertices", contacts.patches.vertices);
  json["joint_areas"] = base64(areas);
}

/** The largest displacement of a vertex, over half of the packing, in the page.
 */
constexpr float largest_motion = 0.4f;

/** Six numbers for each cell, of the size that the page shows. */
std::vector<float> motion_of(const SpaceReport &report, const PlaceList &places)
{
  const CellFaces &cells = *report.cells;
  double largest = 0.;
  for (unsigned int c = 0; c < report.motion.size(); ++c)
  {
    const Point<3> centroid = moments_of(cells, c).centroid;
    const auto &of = report.motion[c];
    for (unsigned int f = cells.first_face[c]; f < cells.first_face[c + 1]; ++f)
      for (const unsigned int v : cells.corners(f))
        largest = std::max(
            largest,
            (of.displacement +
             cross_product_3d(of.rotation, cells.vertices[v] - centroid))
                .norm());
  }
  std::vector<float> numbers;
  if (!(largest > 0.))
    return numbers;
  const double shift = largest_motion / largest, turn = shift * places.scale;
  for (const auto &of : report.motion)
  {
    for (unsigned int d = 0; d < 3; ++d)
      numbers.push_back(shift * of.displacement[d]);
    for (unsigned int d = 0; d < 3; ++d)
      numbers.push_back(turn * of.rotation[d]);
  }
  return numbers;
}

Json field_json(const SpaceField &field,
                const std::string &of,
                const ColourScale &scale)
{
  std::vector<std::uint8_t> steps;
  for (const double value : field.values)
    steps.push_back(std::isfinite(value) ? scale.step(value) : no_colour);
  return {{"name", field.name},
          {"unit", field.unit},
          {"of", of},
          {"colours", scale.colours()},
          {"values", base64(field.values)},
          {"steps", base64(steps)}};
}
} // namespace

std::string space_data(const SpaceReport &report,
                       const std::vector<ColourScale> &cell_scales,
                       const std::vector<ColourScale> &contact_scales)
{
  const CellFaces &cells = *report.cells;
  const FaceContacts none;
  const FaceContacts &contacts = report.contacts ? *report.contacts : none;
  const PlaceList places(box_of(cells));
  Json json = {
      {"cells", cells.n_cells()},
      {"fixed", cells.n_fixed},
      {"joints", contacts.faces.size()},
      {"centre", {places.centre[0], places.centre[1], places.centre[2]}},
      {"scale", places.scale}};
  places.write(json, "vertices", used_vertices(cells));
  write_faces(json, cells);
  write_cells(json, cells);
  write_joints(json, cells, contacts, places);
  json["motion"] = base64(motion_of(report, places));
  json["collapses"] = report.collapses;
  json["fields"] = Json::array();
  for (std::size_t k = 0; k < cell_scales.size(); ++k)
    json["fields"].push_back(
        field_json(report.cell_fields[k], "cells", cell_scales[k]));
  for (std::size_t k = 0; k < contact_scales.size(); ++k)
    json["fields"].push_back(
        field_json(report.contact_fields[k], "joints", contact_scales[k]));
  // Names that are no UTF-8 show what they are not, instead of nothing at all.
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = 0; (at = text.find('<', at)) != text.npos;)
    text.replace(at, 1, "\\u003c");
  return text;
}
} // namespace Voussoir
