// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/models/compas_map.h>
#include <voussoir/packing/polyhedra/models/compas_mesh.h>
#include <voussoir/packing/polyhedra/models/model_text.h>
#include <voussoir/packing/polyhedra/models/readers.h>

#include <boost/lexical_cast/try_lexical_convert.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace Voussoir
{
using Json = nlohmann::ordered_json;

namespace
{
/** Lists within lists that a model may have; a deeper tree is none. */
constexpr unsigned int deepest_list = 16;

/** The bytes before a fault of the notation that its message shows. */
constexpr std::size_t shown_before_fault = 20;

/** Reads one file; one object, used once. */
class CompasReader
{
public:
  explicit CompasReader(const std::filesystem::path &file)
  {
    model.file = file;
  }

  BlockMeshes read()
  {
    const Json tree = parse();
    collect(tree, 0);
    if (model.blocks.empty())
      refuse("is JSON, but no model that is known: an Assembly, a BlockModel, "
             "a mesh or a list of meshes of COMPAS.");
    return std::move(model);
  }

private:
  [[noreturn]] void refuse(const std::string &fault) const
  {
    throw InputError("The COMPAS file '" + model.file.string() + "' " + fault);
  }

  Json parse() const
  {
    const std::string bytes = read_model_bytes(model.file);
    try
    {
      return Json::parse(bytes);
    }
    catch (const Json::parse_error &error)
    {
      const std::size_t at = std::min(error.byte, bytes.size());
      const std::size_t start =
          at - std::min(at, shown_before_fault); // enough to find it
      std::string shown = bytes.substr(start, at - start);
      for (char &letter : shown)
        if (letter < ' ' || letter > '~')
          letter = ' ';
      refuse(text("is no JSON in line ",
                  1 + std::count(bytes.begin(), bytes.begin() + at, '\n'),
                  ", behind '", shown,
                  "'; numbers must be finite, and the file whole."));
    }
    catch (const Json::exception &)
    {
      refuse("has a number or a text that cannot be read.");
    }
  }

  /** Add the block that @p action reads, or say where it is faulty. */
  template <typename Action>
  void add(const std::string &record_name,
           const std::string &key,
           const Action &action)
  {
    try
    {
      model.record_name = record_name;
      BlockMesh block = action();
      block.record = model.blocks.size();
      model.blocks.push_back(std::move(block));
    }
    catch (const CompasFault &fault)
    {
      refuse("has the " + record_name + " '" + key + "', which " +
             fault.what() + ".");
    }
  }

  void collect(const Json &tree, const unsigned int depth)
  {
    const Json &inside = *unwrapped(tree).tree;
    if (inside.is_array())
    {
      if (depth == deepest_list)
        refuse("has lists within lists that are no model.");
      for (const Json &entry : inside)
        collect(entry, depth + 1);
    }
    else if (is_compas_mesh(tree))
      add("mesh", std::to_string(model.blocks.size()),
          [&] { return compas_mesh(tree); });
    else if (const Json *const elements = value_of(inside, "elements"))
      collect_elements(inside, *elements);
    else if (const Json *const blocks = value_of(inside, "blocks"))
      collect_blocks(*blocks, value_of(inside, "assembly"));
    else if (const Json *const graph = value_of(inside, "graph"))
      collect_nodes(*unwrapped(*graph).tree);
    else if (value_of(inside, "node") != nullptr)
      collect_nodes(inside);
  }

  /** Whether a node of a graph is a support. */
  static bool is_support(const Json &graph, const Json *const node)
  {
    if (node != nullptr && value_of(*node, "is_support") != nullptr)
      return is_true(value_of(*node, "is_support"));
    for (const char *const key :
         {"default_node_attributes", "node_attributes", "dna", "dva"})
      if (const Json *const defaults = value_of(graph, key))
        return is_true(value_of(*defaults, "is_support"));
    return false;
  }

  void collect_nodes(const Json &graph)
  {
    const Json *const nodes = value_of(graph, "node");
    if (nodes == nullptr || !nodes->is_object())
      refuse("has an assembly whose graph has no 'node'.");
    const std::size_t first = model.blocks.size();
    std::vector<std::string> keys;
    for (const auto &node : nodes->items())
    {
      const Json *const mesh = value_of(node.value(), "block");
      if (mesh == nullptr || mesh->is_null())
        refuse("has the node '" + node.key() + "', which has no 'block'.");
      add("node", node.key(), [&] {
        BlockMesh block = compas_mesh(*mesh);
        block.is_support |= is_support(graph, &node.value());
        return block;
      });
      keys.push_back(node.key());
    }
    number_by_keys(keys, first);
  }

  /** Blocks beside the graph of the assembly, as in COMPAS 0. */
  void collect_blocks(const Json &blocks, const Json *const assembly)
  {
    if (!blocks.is_object())
      return collect(blocks, 0);
    const Json empty = Json::object();
    const Json &graph = assembly ? *unwrapped(*assembly).tree : empty;
    const Json *nodes = value_of(graph, "node");
    if (nodes == nullptr)
      nodes = value_of(graph, "vertex");
    const std::size_t first = model.blocks.size();
    std::vector<std::string> keys;
    for (const auto &entry : blocks.items())
    {
      add("node", entry.key(), [&] {
        BlockMesh block = compas_mesh(entry.value());
        block.is_support |=
            is_support(graph, nodes ? value_of(*nodes, entry.key()) : nullptr);
        return block;
      });
      keys.push_back(entry.key());
    }
    number_by_keys(keys, first);
  }

  /** Let blocks from @p first on have their keys for records, if they can. */
  void number_by_keys(const std::vector<std::string> &keys,
                      const std::size_t first)
  {
    std::vector<unsigned int> numbers(keys.size());
    for (std::size_t k = 0; k < keys.size(); ++k)
      if (keys[k].empty() || !std::isdigit(keys[k].front()) ||
          !boost::conversion::try_lexical_convert(keys[k], numbers[k]))
        return;
    for (std::size_t k = 0; k < keys.size(); ++k)
      model.blocks[first + k].record = numbers[k];
  }

  void collect_elements(const Json &tree, const Json &elements)
  {
    std::map<std::string, AffineMap> maps; // of what contains an element
    AffineMap outer;
    if (const auto map = checked_map(value_of(tree, "transformation"), "model"))
      outer = *map;
    if (const Json *const hierarchy = value_of(tree, "tree"))
      if (const Json *const root =
              value_of(*unwrapped(*hierarchy).tree, "root"))
        map_children(*root, elements, outer, maps);
    for (const auto &element : elements.items())
    {
      const Json &inside = *unwrapped(element.value()).tree;
      const Json *geometry = value_of(inside, "geometry");
      if (geometry == nullptr)
        geometry = value_of(inside, "shape"); // in the first form of it
      if (geometry == nullptr || geometry->is_null())
        continue; // a group of others
      add("element", element.key(), [&] {
        if (!is_compas_mesh(*geometry))
          throw CompasFault("has a geometry that is no mesh");
        const auto found = maps.find(element.key());
        return placed_element(inside, *geometry,
                              found == maps.end() ? outer : found->second);
      });
    }
  }

  std::optional<AffineMap> checked_map(const Json *const tree,
                                       const std::string &owner) const
  {
    try
    {
      return compas_map(tree);
    }
    catch (const CompasFault &fault)
    {
      refuse("has the " + owner + ", which " + fault.what() + ".");
    }
  }

  /** Maps of elements by what contains them: the model, and groups. */
  void map_children(const Json &parent,
                    const Json &elements,
                    const AffineMap &outer,
                    std::map<std::string, AffineMap> &maps) const
  {
    const Json *const children = value_of(parent, "children");
    if (children == nullptr || !children->is_array())
      return;
    for (const Json &child : *children)
    {
      const Json *const key = value_of(child, "element");
      AffineMap inner = outer;
      if (key != nullptr && key->is_string())
      {
        const std::string name = key->get<std::string>();
        maps[name] = outer;
        if (value_of(child, "children") != nullptr)
          if (const Json *const group = value_of(elements, name))
            if (const auto map = checked_map(
                    value_of(*unwrapped(*group).tree, "transformation"),
                    "element '" + name + "'"))
              inner = outer.after(*map);
      }
      map_children(child, elements, inner, maps);
    }
  }

  static BlockMesh placed_element(const Json &element,
                                  const Json &geometry,
                                  const AffineMap &outer)
  {
    BlockMesh block = compas_mesh(geometry);
    const auto own = compas_map(value_of(element, "transformation"));
    const AffineMap map = own ? outer.after(*own) : outer;
    if (map.A != AffineMap().A || map.b != AffineMap().b)
      for (dealii::Point<3> &vertex : block.vertices)
        if (std::isfinite(vertex.norm_square())) // else it is refused later
          vertex = map(vertex);
    block.is_support |= is_true(value_of(element, "is_support"));
    if (const std::string name = own_name(element); !name.empty())
      block.name = name;
    return block;
  }

  BlockMeshes model;
};
} // namespace

BlockMeshes read_compas_model(const std::filesystem::path &file)
{
  return CompasReader(file).read();
}
} // namespace Voussoir
