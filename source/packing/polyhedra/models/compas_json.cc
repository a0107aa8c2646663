// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/models/compas_json.h>

#include <algorithm>
#include <unordered_set>

namespace Voussoir
{
using Json = nlohmann::ordered_json;

namespace
{
/**
 * Lists and objects within one another that a tree may have, which is gone
 * through by functions that call themselves.
 */
constexpr int deepest_tree = 1000;

/** The bytes before a fault of the notation that its message shows. */
constexpr std::size_t shown_before_fault = 20;

/** Finds keys that an object has twice, of which the tree keeps one. */
class KeysOfObjects
{
public:
  /** See what is parsed, one event after the other. */
  void see(const Json::parse_event_t event, const Json &parsed)
  {
    if (event == Json::parse_event_t::object_start)
      open.emplace_back();
    else if (event == Json::parse_event_t::object_end)
      open.pop_back();
    else if (event == Json::parse_event_t::key)
    {
      Keys &keys = open.back();
      keys.last = parsed.get<std::string>();
      if (!keys.all.insert(keys.last).second)
        found.push_back("the key '" + keys.last + "'" +
                        (open.size() > 1
                             ? " of '" + open[open.size() - 2].last + "'"
                             : ""));
    }
  }
  /** Each with what has it, such as "the key '3' of 'node'". */
  const std::vector<std::string> &repeated() const { return found; }

private:
  struct Keys
  {
    std::unordered_set<std::string> all;
    std::string last;
  };
  std::vector<Keys> open;
  std::vector<std::string> found;
};
} // namespace

CompasTree parse_compas(const std::string &bytes,
                        const std::function<void(const std::string &)> &refuse)
{
  KeysOfObjects keys;
  CompasTree tree;
  try
  {
    tree.json =
        Json::parse(bytes, [&](const int depth, const Json::parse_event_t event,
                               const Json &parsed) {
          if (depth > deepest_tree)
            refuse(text("has more than ", deepest_tree,
                        " lists and objects within one another, more than any "
                        "model; remove the innermost."));
          keys.see(event, parsed);
          return true;
        });
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
  tree.repeated_keys = keys.repeated();
  return tree;
}
} // namespace Voussoir
