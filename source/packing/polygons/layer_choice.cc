// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/group_names.h>
#include <voussoir/packing/polygons/layer_choice.h>

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <fnmatch.h>

namespace Voussoir
{
namespace
{
bool fits(const std::string &layer, const std::string &name)
{
  return fnmatch(name.c_str(), layer.c_str(), 0) == 0;
}

} // namespace

LayerChoice::LayerChoice(const std::string &chosen, const std::string &named)
    : names(chosen.empty() ? std::vector<std::string>() : split_names(chosen)),
      groups(named.empty()
                 ? decltype(groups)()
                 : split_named_list(named, "Packing/polygons/Layer groups"))
{
  if (std::find(names.begin(), names.end(), "") != names.end())
    throw InputError("'Packing/polygons/Layers' = '" + chosen +
                     "' has an empty name; give names of layers with commas "
                     "between them.");
}

bool LayerChoice::takes(const std::string &name)
{
  auto layer =
      std::find_if(layers.begin(), layers.end(),
                   [&](const Layer &other) { return other.name == name; });
  if (layer == layers.end())
  {
    layers.push_back({name});
    layer = layers.end() - 1;
  }
  const bool is_taken = names.empty() || std::any_of(names.begin(), names.end(),
                                                     [&](const std::string &n) {
                                                       return fits(name, n);
                                                     });
  layer->is_taken |= is_taken;
  return is_taken;
}

std::string LayerChoice::group_of(const std::string &layer,
                                  const std::string &otherwise) const
{
  for (const auto &[name, group] : groups)
    if (fits(layer, name))
      return group;
  return otherwise;
}

std::string LayerChoice::listed(const bool only_taken) const
{
  std::vector<std::string> found;
  for (const Layer &layer : layers)
    if (layer.is_taken || !only_taken)
      found.push_back("'" + layer.name + "'");
  return found.empty() ? "none" : boost::algorithm::join(found, ", ");
}

void LayerChoice::check(const std::string &file) const
{
  const auto is_there = [&](const std::string &name, const bool only_taken) {
    return std::any_of(layers.begin(), layers.end(), [&](const Layer &layer) {
      return (layer.is_taken || !only_taken) && fits(layer.name, name);
    });
  };
  for (const std::string &name : names)
    if (!is_there(name, false))
      throw InputError("'Packing/polygons/Layers' names the layer '" + name +
                       "', of which '" + file +
                       "' has nothing; its layers are " + listed(false) + '.');
  for (const auto &[name, group] : groups)
    if (!is_there(name, true))
      throw InputError("'Packing/polygons/Layer groups' names the layer '" +
                       name + "', of which nothing of '" + file +
                       "' is read; the layers that are read are " +
                       listed(true) + '.');
}
} // namespace Voussoir
