// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_compas_mesh_h
#define voussoir_packing_polyhedra_models_compas_mesh_h

#include <voussoir/packing/polyhedra/models/block_mesh.h>

#include <nlohmann/json.hpp>

#include <stdexcept>
#include <string>
#include <vector>

namespace Voussoir
{
/** A tree of COMPAS that lacks something, as the end of a sentence on it. */
class CompasFault : public std::runtime_error
{
public:
  /** @param fault the end of a sentence, with what to do. */
  CompasFault(const ModelDefect::Kind kind, const std::string &fault)
      : std::runtime_error(fault), kind(kind)
  {}

  /** What it is; ModelDefect::is_of_file(). */
  ModelDefect::Kind kind;
};

/** A block of COMPAS, as far as it could be read. */
struct CompasBlock
{
  /** The block. */
  BlockMesh mesh;
  /** What could not be read. */
  std::vector<CompasFault> faults;
};

/** The value of a key of an object; null if there is none. */
const nlohmann::ordered_json *value_of(const nlohmann::ordered_json &tree,
                                       const std::string &key);

/**
 * True for true, and for a number that is not zero; not for null, and what is
 * not there.
 *
 * @throws CompasFault if it is anything else.
 */
bool is_true(const nlohmann::ordered_json *value);

/** The name of a tree; empty if it is none, or one that COMPAS gives to all. */
std::string own_name(const nlohmann::ordered_json &tree);

/** What {"dtype", "data"} and its like wrap, and the name that they give it. */
struct CompasContent
{
  /** Inside of all wrappings; not null. */
  const nlohmann::ordered_json *tree;
  /** Empty if there is none. */
  std::string name;
};

/** Take all wrappings off. */
CompasContent unwrapped(const nlohmann::ordered_json &tree);

/** True if the tree, without wrappings, is a mesh. */
bool is_compas_mesh(const nlohmann::ordered_json &tree);

/**
 * The block that a mesh is, with or without wrappings: its vertices and faces
 * in their order, its name unless it is one that COMPAS gives by itself, and
 * whether its attributes call it a support.
 */
CompasBlock compas_mesh(const nlohmann::ordered_json &tree);
} // namespace Voussoir

#endif
