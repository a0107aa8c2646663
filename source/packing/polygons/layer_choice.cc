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

std::string in_quotes(std::vector<std::string> names)
{
  for (std::string &name : names)
    name = "'" + name + "'";
  return boost::algorithm::join(names, ", ");
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
                     "' has an empty name; it is a list of names of layers "
                     "with commas between them.");
}

bool LayerChoice::takes(const std::string &name, const bool is_hidden)
{
  auto layer =
      std::find_if(layers.begin(), layers.end(),
                   [&](const Layer &other) { return other.name == name; });
  if (layer == layers.end())
  {
    layers.push_back({name});
    layer = layers.end() - 1;
  }
  const bool is_taken =
      names.empty()
          ? !is_hidden
          : std::any_of(names.begin(), names.end(),
                        [&](const std::string &n) { return fits(name, n); });
  layer->is_taken |= is_taken;
  layer->n_hidden += names.empty() && is_hidden;
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
      found.push_back(layer.name);
  return found.empty() ? "none" : in_quotes(found);
}

std::string LayerChoice::listed_hidden() const
{
  std::vector<std::string> found;
  for (const Layer &layer : layers)
    if (layer.n_hidden > 0)
      found.push_back(layer.name);
  return in_quotes(found);
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

std::string LayerChoice::left_out(const std::string &file) const
{
  unsigned int n_hidden = 0;
  for (const Layer &layer : layers)
    n_hidden += layer.n_hidden;
  return n_hidden == 0
             ? ""
             : text(counted(n_hidden, "feature"), " of '", file,
                    "' on layers that are off or frozen, ", listed_hidden(),
                    n_hidden == 1 ? ", is" : ", are",
                    " left out; 'Packing/polygons/Layers' reads what it "
                    "names.");
}

std::string LayerChoice::hint() const
{
  const std::string hidden = listed_hidden();
  return hidden.empty()
             ? ""
             : " on layers that are neither off nor frozen, as " + hidden +
                   " are: name these in 'Packing/polygons/Layers'";
}
} // namespace Voussoir
