// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/cell_moments.h>
#include <voussoir/packing/polyhedra/models/cell_vertices.h>
#include <voussoir/packing/polyhedra/models/writers.h>

#include <deal.II/base/tensor.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
using Json = nlohmann::ordered_json;

namespace
{
Json json_of(const dealii::Tensor<1, 3> &x)
{
  return {x[0], x[1], x[2]};
}

Json json_of_point(const dealii::Point<3> &p)
{
  return {{"x", p[0]}, {"y", p[1]}, {"z", p[2]}};
}

/** Add a key that an object does not have, without looking for it. */
void add_new(Json &object, const std::string &key, Json value)
{
  object.get_ref<Json::object_t &>().emplace_back(key, std::move(value));
}

/** A tree of COMPAS of a type. */
Json wrapped(const std::string &type, Json data)
{
  return {{"dtype", type}, {"data", std::move(data)}};
}

Json json_of_block(const CellFaces &cells, const unsigned int cell)
{
  const std::vector<unsigned int> vertices = vertices_of_cell(cells, cell);
  Json places = Json::object(), faces = Json::object(),
       face_data = Json::object();
  for (std::size_t v = 0; v < vertices.size(); ++v)
    add_new(places, std::to_string(v),
            json_of_point(cells.vertices[vertices[v]]));
  const unsigned int begin = cells.first_face[cell];
  const unsigned int end = cells.first_face[cell + 1];
  for (unsigned int face = begin; face < end; ++face)
  {
    Json loop = Json::array();
    for (const unsigned int corner : cells.corners(face))
      loop.push_back(place_in_list(vertices, corner));
    const std::string key = std::to_string(face - begin);
    add_new(faces, key, std::move(loop));
    add_new(face_data, key, Json::object());
  }
  const dealii::Point<3> origin;
  return wrapped(
      "compas_assembly.datastructures/Block",
      {{"attributes", {{"name", group_name_of(cells, cell)}, {"node", cell}}},
       {"default_vertex_attributes", json_of_point(origin)},
       {"default_edge_attributes", Json::object()},
       {"default_face_attributes", Json::object()},
       {"vertex", std::move(places)},
       {"face", std::move(faces)},
       {"facedata", std::move(face_data)},
       {"edgedata", Json::object()},
       {"max_vertex", static_cast<int>(vertices.size()) - 1},
       {"max_face", static_cast<int>(end - begin) - 1}});
}

Json json_of_node(const CellFaces &cells, const unsigned int cell)
{
  Json node = json_of_point(moments_of(cells, cell).centroid);
  node["block"] = json_of_block(cells, cell);
  node["is_support"] = cell >= cells.n_cells() - cells.n_fixed;
  return node;
}

/** An interface, with a frame whose normal is that of the polygon. */
Json json_of_interface(const dealii::ArrayView<const dealii::Point<3>> patch,
                       const std::vector<dealii::Tensor<1, 3>> &at_corners)
{
  const PolygonMoments moments = moments_of(patch);
  const dealii::Tensor<1, 3> normal = moments.normal();
  dealii::Tensor<1, 3> along; // the longest side
  Json points = Json::array();
  for (unsigned int i = 0; i < patch.size(); ++i)
  {
    const dealii::Tensor<1, 3> side = patch[(i + 1) % patch.size()] - patch[i];
    if (side.norm() > along.norm())
      along = side;
    points.push_back(json_of(patch[i]));
  }
  along -= (along * normal) * normal;
  along /= along.norm();
  const dealii::Tensor<1, 3> across = cross_product_3d(normal, along);
  Json forces;
  for (const dealii::Tensor<1, 3> &force : at_corners)
    forces.push_back({{"c_np", std::max(force * normal, 0.)},
                      {"c_nn", std::max(-(force * normal), 0.)},
                      {"c_u", force * along},
                      {"c_v", force * across}});
  return wrapped("compas_assembly.datastructures/Interface",
                 {{"points", std::move(points)},
                  {"size", moments.area()},
                  {"frame", wrapped("compas.geometry/Frame",
                                    {{"point", json_of(moments.centroid)},
                                     {"xaxis", json_of(along)},
                                     {"yaxis", json_of(across)}})},
                  {"forces", std::move(forces)},
                  {"mesh", nullptr}});
}

Json json_of_edges(const CellFaces &cells,
                   const FaceContacts *const contacts,
                   const ForcesAtCorners &forces)
{
  const std::vector<dealii::Tensor<1, 3>> none;
  std::vector<Json> of_cell(cells.n_cells(), Json::object());
  for (unsigned int k = 0; contacts != nullptr && k < contacts->faces.size();
       ++k)
  {
    const auto [a, b] = contacts->faces[k];
    if (a == b || !(moments_of(contacts->patches[k]).area() > 0.))
      continue; // it has no other node, or no frame
    Json &edge =
        of_cell[cells.cell_of_face(a)][std::to_string(cells.cell_of_face(b))];
    if (edge.is_null())
      edge["interfaces"] = Json::array();
    edge["interfaces"].push_back(json_of_interface(
        contacts->patches[k], forces.empty() ? none : forces[k]));
  }
  Json edges = Json::object();
  for (unsigned int cell = 0; cell < cells.n_cells(); ++cell)
    add_new(edges, std::to_string(cell), std::move(of_cell[cell]));
  return edges;
}
} // namespace

void write_compas_assembly(std::ostream &out,
                           const CellFaces &cells,
                           const FaceContacts *const contacts,
                           const ForcesAtCorners &forces)
{
  Json node_defaults = json_of_point(dealii::Point<3>());
  node_defaults["block"] = nullptr;
  node_defaults["is_support"] = false;
  Json nodes = Json::object();
  for (unsigned int cell = 0; cell < cells.n_cells(); ++cell)
    add_new(nodes, std::to_string(cell), json_of_node(cells, cell));
  const Json assembly = wrapped(
      "compas_assembly.datastructures/Assembly",
      {{"attributes", {{"name", "Assembly"}}},
       {"graph",
        wrapped("compas.datastructures/Graph",
                {{"attributes", Json::object()},
                 {"default_node_attributes", std::move(node_defaults)},
                 {"default_edge_attributes", {{"interfaces", nullptr}}},
                 {"node", std::move(nodes)},
                 {"edge", json_of_edges(cells, contacts, forces)},
                 {"max_node", static_cast<int>(cells.n_cells()) - 1}})}});
  out << assembly << '\n';
}
} // namespace Voussoir
