// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/models/compas_mesh.h>

#include <boost/lexical_cast/try_lexical_convert.hpp>

#include <array>
#include <limits>
#include <set>
#include <unordered_map>

namespace Voussoir
{
using Json = nlohmann::ordered_json;
using DefectKind = ModelDefect::Kind;

const Json *value_of(const Json &tree, const std::string &key)
{
  if (!tree.is_object())
    return nullptr;
  const auto found = tree.find(key);
  return found == tree.end() ? nullptr : &*found;
}

bool is_true(const Json *const value)
{
  if (value == nullptr || value->is_null())
    return false;
  if (value->is_boolean())
    return value->get<bool>();
  if (value->is_number())
    return value->get<double>() != 0.;
  throw CompasFault(DefectKind::bad_flag,
                    "has 'is_support' = " + value->dump() +
                        ", which is neither true nor false; write one of them");
}

namespace
{
/** The keys by which the trees that are wrapped are known. */
constexpr const char *keys_of_content[] = {
    "vertex", "node", "elements", "graph", "blocks", "geometry", "shape"};

/** The numbers of vertices by their keys. */
using VertexKeys = std::unordered_map<std::string, unsigned int>;

std::string text_of_key(const Json &key)
{
  return key.is_string() ? key.get<std::string>() : key.dump();
}

/** Null, which stands for what is no number in JSON, is not a number. */
double coordinate_of(const Json &value, const std::string &key)
{
  double x = 0.;
  if (value.is_number())
    return value.get<double>();
  if (value.is_null())
    return std::numeric_limits<double>::quiet_NaN();
  if (value.is_string() &&
      boost::conversion::try_lexical_convert(value.get<std::string>(), x))
    return x;
  throw CompasFault(DefectKind::bad_coordinate,
                    "has the coordinate " + value.dump() + " of vertex '" +
                        key + "', which is no number; write one");
}

dealii::Point<3> compas_place(const Json &vertex,
                              const std::string &key,
                              const Json *const defaults)
{
  dealii::Point<3> place;
  const std::array<std::string, 3> axes = {{"x", "y", "z"}};
  for (unsigned int d = 0; d < 3; ++d)
    if (vertex.is_array() && vertex.size() == 3)
      place[d] = coordinate_of(vertex[d], key);
    else if (const Json *const x = value_of(vertex, axes[d]))
      place[d] = coordinate_of(*x, key);
    else if (const Json *const x =
                 defaults ? value_of(*defaults, axes[d]) : nullptr)
      place[d] = coordinate_of(*x, key);
    else
      throw CompasFault(DefectKind::missing_coordinate,
                        "has no " + axes[d] + " of vertex '" + key +
                            "', and no default for it; add it");
  return place;
}

unsigned int compas_vertex(const VertexKeys &keys,
                           const std::string &key,
                           const std::string &face)
{
  const auto found = keys.find(key);
  if (found == keys.end())
    throw CompasFault(DefectKind::unknown_vertex,
                      "has face '" + face + "' with the vertex '" + key +
                          "', which is not there; change it, or add the "
                          "vertex");
  return found->second;
}

/** The loop of a face that gives for each vertex the next one. */
std::vector<unsigned int>
loop_of_next(const std::vector<std::array<unsigned int, 2>> &half_edges,
             const std::string &face)
{
  std::unordered_map<unsigned int, unsigned int> next;
  for (const auto &[from, to] : half_edges)
    next[from] = to;
  std::vector<unsigned int> loop;
  if (half_edges.empty())
    return loop;
  const unsigned int start = half_edges.front()[0];
  for (unsigned int v = start; loop.size() < half_edges.size();)
  {
    loop.push_back(v);
    const auto found = next.find(v);
    if (found == next.end())
      break;
    v = found->second;
    if (v == start)
    {
      if (loop.size() == half_edges.size())
        return loop;
      break;
    }
  }
  throw CompasFault(DefectKind::bad_half_edges,
                    "has half-edges of face '" + face +
                        "' that are not one closed loop; export it again");
}

void add_compas_face(const Json &loop,
                     const std::string &face,
                     const VertexKeys &keys,
                     BlockMesh &block)
{
  if (loop.is_object())
  {
    std::vector<std::array<unsigned int, 2>> half_edges;
    for (const auto &edge : loop.items())
      half_edges.push_back(
          {{compas_vertex(keys, edge.key(), face),
            compas_vertex(keys, text_of_key(edge.value()), face)}});
    block.faces.add(loop_of_next(half_edges, face));
    return;
  }
  if (!loop.is_array())
    throw CompasFault(DefectKind::bad_face,
                      "has face '" + face +
                          "' that is no list of vertices, but " + loop.dump() +
                          "; write their keys as [0, 1, 2]");
  std::vector<unsigned int> corners;
  for (const Json &key : loop)
    corners.push_back(compas_vertex(keys, text_of_key(key), face));
  block.faces.add(corners);
}

/** Do what may find a fault, and keep that. */
template <typename Action>
void keep_fault(std::vector<CompasFault> &faults, const Action &action)
{
  try
  {
    action();
  }
  catch (const CompasFault &fault)
  {
    faults.push_back(fault);
  }
}

/** The faces of a mesh that has only half-edges {from: {to: face}}. */
void add_faces_of_half_edges(const Json &tree,
                             const VertexKeys &keys,
                             CompasBlock &block)
{
  std::vector<std::string> names;
  std::unordered_map<std::string, std::vector<std::array<unsigned int, 2>>>
      half_edges;
  for (const auto &from : tree.items())
    if (from.value().is_object())
      for (const auto &to : from.value().items())
        if (!to.value().is_null())
          keep_fault(block.faults, [&] {
            const std::string face = text_of_key(to.value());
            auto &of_face = half_edges[face];
            if (of_face.empty())
              names.push_back(face);
            of_face.push_back({{compas_vertex(keys, from.key(), face),
                                compas_vertex(keys, to.key(), face)}});
          });
  for (const std::string &face : names)
    keep_fault(block.faults, [&] {
      block.mesh.faces.add(loop_of_next(half_edges.at(face), face));
    });
}

/** A list of things by their keys, whether these are written or not. */
template <typename Action>
void for_each_entry(const Json &tree, const Action &action)
{
  unsigned int number = 0;
  if (tree.is_object())
    for (const auto &entry : tree.items())
      action(entry.key(), entry.value());
  else if (tree.is_array())
    for (const Json &entry : tree)
      action(std::to_string(number++), entry);
}
} // namespace

std::string own_name(const Json &tree)
{
  static const std::set<std::string> names_of_all = {
      "Mesh", "Block", "Box", "Element", "BlockElement", "Polyhedron"};
  const Json *const name = value_of(tree, "name");
  if (name == nullptr || !name->is_string() ||
      names_of_all.count(name->get<std::string>()) > 0)
    return "";
  return name->get<std::string>();
}

CompasContent unwrapped(const Json &tree)
{
  CompasContent content = {&tree, ""};
  const auto is_content = [&] {
    for (const char *const key : keys_of_content)
      if (value_of(*content.tree, key) != nullptr)
        return true;
    return false;
  };
  while (content.tree->is_object() && !is_content())
  {
    if (const std::string name = own_name(*content.tree); !name.empty())
      content.name = name;
    const Json *inside = value_of(*content.tree, "data");
    if (inside == nullptr)
      inside = value_of(*content.tree, "value");
    if (inside == nullptr)
      break;
    content.tree = inside;
  }
  return content;
}

bool is_compas_mesh(const Json &tree)
{
  const Json &mesh = *unwrapped(tree).tree;
  return value_of(mesh, "vertex") != nullptr &&
         (value_of(mesh, "face") != nullptr ||
          value_of(mesh, "halfedge") != nullptr);
}

CompasBlock compas_mesh(const Json &tree)
{
  const auto [content, name] = unwrapped(tree);
  CompasBlock block;
  BlockMesh &mesh = block.mesh;
  if (!is_compas_mesh(*content))
  {
    block.faults.emplace_back(
        DefectKind::other_shape,
        "is no mesh with 'vertex' and 'face'; export it as one");
    return block;
  }
  mesh.name = name;
  if (const Json *const attributes = value_of(*content, "attributes"))
  {
    if (const std::string name = own_name(*attributes); !name.empty())
      mesh.name = name;
    keep_fault(block.faults, [&] {
      mesh.is_support = is_true(value_of(*attributes, "is_support"));
    });
  }
  const Json *defaults = value_of(*content, "default_vertex_attributes");
  if (defaults == nullptr)
    defaults = value_of(*content, "dva");
  VertexKeys keys;
  for_each_entry(*value_of(*content, "vertex"),
                 [&](const std::string &key, const Json &vertex) {
                   keys[key] = mesh.vertices.size();
                   mesh.vertices.emplace_back();
                   keep_fault(block.faults, [&] {
                     mesh.vertices.back() = compas_place(vertex, key, defaults);
                   });
                 });
  if (const Json *const faces = value_of(*content, "face"))
    for_each_entry(*faces, [&](const std::string &key, const Json &loop) {
      keep_fault(block.faults, [&] { add_compas_face(loop, key, keys, mesh); });
    });
  else
    add_faces_of_half_edges(*value_of(*content, "halfedge"), keys, block);
  return block;
}
} // namespace Voussoir
