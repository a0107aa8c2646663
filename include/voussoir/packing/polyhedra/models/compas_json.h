// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_compas_json_h
#define voussoir_packing_polyhedra_models_compas_json_h

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

namespace Voussoir
{
/** What a file of COMPAS has, as it stands there. */
struct CompasTree
{
  /** The tree, with the last of values that have the same key. */
  nlohmann::ordered_json json;
  /** Those keys, each with what has it, such as "the key '3' of 'node'". */
  std::vector<std::string> repeated_keys;
};

/**
 * Parse the bytes of a file.
 *
 * @param refuse throws for what is no JSON, or deeper than any model; it takes
 *   the end of the sentence.
 */
CompasTree parse_compas(const std::string &bytes,
                        const std::function<void(const std::string &)> &refuse);
} // namespace Voussoir

#endif
