// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/models/compas_json.h>
#include <voussoir/packing/polyhedra/models/compas_map.h>
#include <voussoir/packing/polyhedra/models/compas_mesh.h>
#include <voussoir/packing/polyhedra/models/model_text.h>
#include <voussoir/packing/polyhedra/models/readers.h>

#include <boost/lexical_cast/try_lexical_convert.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace Voussoir
{
using Json = nlohmann::ordered_json;
using DefectKind = ModelDefect::Kind;

namespace
{
/** Lists within lists that a model may have; a deeper tree is none. */
constexpr unsigned int deepest_list = 16;

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
    collect(tree, 0, "");
    const bool has_faults =
        std::any_of(model.faults.begin(), model.faults.end(),
                    [](const ModelDefect &d) { return d.is_refusal(); });
    if (model.blocks.empty() && !has_faults)
      refuse("is JSON, but no model that is known: an Assembly, a BlockModel, "
             "a mesh or a list of meshes of COMPAS.");
    return std::move(model);
  }

private:
  [[noreturn]] void refuse(const std::string &fault) const
  {
    throw InputError("The COMPAS file '" + model.file.string() + "' " + fault);
  }

  Json parse()
  {
    CompasTree tree =
        parse_compas(read_model_bytes(model.file),
                     [this](const std::string &fault) { refuse(fault); });
    for (const std::string &repeated : tree.repeated_keys)
      model.faults.push_back(fault_of_file(
          DefectKind::repeated_key,
          "'" + model.file.string() + "' has " + repeated +
              " twice, of which one is lost; rename or delete it"));
    return std::move(tree.json);
  }

  static ModelDefect fault_of_file(const DefectKind kind,
                                   const std::string &sentence)
  {
    ModelDefect fault = {kind, dealii::numbers::invalid_unsigned_int};
    fault.detail = sentence + '.';
    return fault;
  }

  /** What faults of one thing are for the file: the first of each kind. */
  std::vector<ModelDefect>
  faults_of(const std::string &thing,
            const std::vector<CompasFault> &found) const
  {
    std::map<DefectKind, std::vector<const CompasFault *>> kinds;
    for (const CompasFault &fault : found)
      kinds[fault.kind].push_back(&fault);
    std::vector<ModelDefect> faults;
    for (const auto &[kind, of_kind] : kinds)
      faults.push_back(fault_of_file(
          kind,
          text("The ", thing, " of '", model.file.string(), "' ",
               of_kind.front()->what(),
               of_kind.size() > 1 ? text(" (and ", of_kind.size() - 1, " more)")
                                  : "")));
    return faults;
  }

  /** Add the block that @p action reads, with what is faulty. */
  template <typename Action>
  void add(const std::string &record_name,
           const std::string &key,
           const Action &action)
  {
    model.record_name = model.blocks.empty() || model.record_name == record_name
                            ? record_name
                            : "block";
    CompasBlock block;
    try
    {
      block = action();
    }
    catch (const CompasFault &fault)
    {
      block.faults.push_back(fault);
    }
    block.mesh.faults = faults_of(record_name + " '" + key + "'", block.faults);
    block.mesh.record = model.blocks.size();
    model.blocks.push_back(std::move(block.mesh));
  }

  void
  collect(const Json &tree, const unsigned int depth, const std::string &entry)
  {
    const Json &inside = *unwrapped(tree).tree;
    if (inside.is_array())
    {
      if (depth == deepest_list)
        refuse("has lists within lists that are no model.");
      for (std::size_t k = 0; k < inside.size(); ++k)
        collect(inside[k], depth + 1, text(entry, '[', k, ']'));
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
    else if (!entry.empty())
    {
      model.faults.push_back(
          {DefectKind::skipped_entry, dealii::numbers::invalid_unsigned_int});
      model.faults.back().detail = entry;
    }
  }

  /** A block that is also a support if @p is_one finds it to be one. */
  template <typename Question>
  static CompasBlock with_support(CompasBlock block, const Question &is_one)
  {
    try
    {
      block.mesh.is_support |= is_one();
    }
    catch (const CompasFault &fault)
    {
      block.faults.push_back(fault);
    }
    return block;
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
      add("node", node.key(), [&] {
        if (mesh == nullptr || mesh->is_null())
          throw CompasFault(DefectKind::no_mesh,
                            "has no 'block'; add its mesh, or delete it");
        return with_support(compas_mesh(*mesh),
                            [&] { return is_support(graph, &node.value()); });
      });
      keys.push_back(node.key());
    }
    number_by_keys(keys, first);
  }

  /** Blocks beside the graph of the assembly, as in COMPAS 0. */
  void collect_blocks(const Json &blocks, const Json *const assembly)
  {
    if (!blocks.is_object())
      return collect(blocks, 0, "");
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
        return with_support(compas_mesh(entry.value()), [&] {
          return is_support(graph,
                            nodes ? value_of(*nodes, entry.key()) : nullptr);
        });
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
    ElementPlaces places;
    places.outer = map_of(value_of(tree, "transformation"), "model");
    if (const Json *const hierarchy = value_of(tree, "tree"))
      if (const Json *const root =
              value_of(*unwrapped(*hierarchy).tree, "root"))
        map_children(*root, elements, places.outer, places);
    for (const auto &element : elements.items())
    {
      const Json &inside = *unwrapped(element.value()).tree;
      const Json *geometry = value_of(inside, "geometry");
      if (geometry == nullptr)
        geometry = value_of(inside, "shape"); // in the first form of it
      const bool has_shape = geometry != nullptr && !geometry->is_null();
      if (!has_shape && places.groups.count(element.key()) > 0)
        continue;
      add("element", element.key(), [&] {
        if (!has_shape)
          throw CompasFault(DefectKind::no_mesh,
                            "has no geometry, nor elements below it; add its "
                            "mesh, or delete it");
        if (!is_compas_mesh(*geometry))
          throw CompasFault(
              DefectKind::other_shape,
              "has a geometry that is no mesh; export it as a mesh");
        const auto found = places.maps.find(element.key());
        return placed_element(inside, *geometry,
                              found == places.maps.end() ? places.outer
                                                         : found->second);
      });
    }
  }

  /** Where elements are put by what contains them. */
  struct ElementPlaces
  {
    AffineMap outer; // of the model
    std::map<std::string, AffineMap> maps;
    std::set<std::string> groups; // elements that contain others
  };

  /** The map of a model or a group; none if it is faulty. */
  AffineMap map_of(const Json *const tree, const std::string &owner)
  {
    try
    {
      return compas_map(tree).value_or(AffineMap());
    }
    catch (const CompasFault &fault)
    {
      const std::vector<ModelDefect> faults = faults_of(owner, {fault});
      model.faults.insert(model.faults.end(), faults.begin(), faults.end());
      return {};
    }
  }

  /** Find the places of elements below one in the hierarchy. */
  void map_children(const Json &parent,
                    const Json &elements,
                    const AffineMap &outer,
                    ElementPlaces &places)
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
        check_place(name, elements, places);
        places.maps[name] = outer;
        const Json *const below = value_of(child, "children");
        const Json *const group = value_of(elements, name);
        if (below != nullptr && !below->empty() && group != nullptr)
        {
          places.groups.insert(name);
          inner = outer.after(
              map_of(value_of(*unwrapped(*group).tree, "transformation"),
                     "element '" + name + "'"));
        }
      }
      map_children(child, elements, inner, places);
    }
  }

  /** Find elements that are twice in the hierarchy, or are not there. */
  void check_place(const std::string &name,
                   const Json &elements,
                   const ElementPlaces &places)
  {
    const std::string thing = "The hierarchy of '" + model.file.string() +
                              "' has the element '" + name + "'";
    if (value_of(elements, name) == nullptr)
      model.faults.push_back(
          fault_of_file(DefectKind::unknown_element,
                        thing + ", which is not among 'elements'; add it, or "
                                "delete it there"));
    else if (places.maps.count(name) > 0)
      model.faults.push_back(
          fault_of_file(DefectKind::repeated_element,
                        thing + " twice, so that it is not known which group "
                                "moves it; delete one of them"));
  }

  static CompasBlock placed_element(const Json &element,
                                    const Json &geometry,
                                    const AffineMap &outer)
  {
    CompasBlock block = compas_mesh(geometry);
    BlockMesh &mesh = block.mesh;
    try
    {
      const auto own = compas_map(value_of(element, "transformation"));
      const AffineMap map = own ? outer.after(*own) : outer;
      if (map.A != AffineMap().A || map.b != AffineMap().b)
        for (dealii::Point<3> &vertex : mesh.vertices)
          if (std::isfinite(vertex.norm_square())) // else it is refused later
            vertex = map(vertex);
    }
    catch (const CompasFault &fault)
    {
      block.faults.push_back(fault);
    }
    if (const std::string name = own_name(element); !name.empty())
      mesh.name = name;
    return with_support(std::move(block), [&] {
      return is_true(value_of(element, "is_support"));
    });
  }

  BlockMeshes model;
};
} // namespace

BlockMeshes read_compas_model(const std::filesystem::path &file)
{
  return CompasReader(file).read();
}
} // namespace Voussoir
