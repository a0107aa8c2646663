// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/unused_settings.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <nlohmann/json.hpp>

#include <sstream>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

/** Entries that only one value of another entry of their section uses. */
struct Use
{
  std::vector<std::string> section;
  std::string choice;
  std::string value;
  std::vector<std::string> entries;
};

const std::vector<Use> uses = {
    {{"Loads"}, "Boundary load", "traction", {"Traction"}},
    {{"Loads"}, "Boundary load", "uniform stress", {"Stress"}},
    {{"Packing", "Voronoi"}, "Points", "file", {"Points file"}},
    {{"Packing", "Voronoi"}, "Points", "random", {"Number of points", "Seed"}},
    {{"Packing", "Voronoi"},
     "Domain",
     "rectangle",
     {"Lower left", "Upper right"}},
    {{"Packing", "Voronoi"}, "Domain", "polygon", {"Polygon"}},
    {{"Packing", "arch"}, "Shape", "circular", {"Mean radius", "Embrace"}},
    {{"Packing", "arch"}, "Shape", "pointed", {"Span", "Radius over span"}},
    {{"Packing", "wall"}, "Lintels", "true", {"Lintel bearing"}}};

bool is_changed(const Json &entry)
{
  const std::string value = entry["value"], fallback = entry["default_value"];
  if (value == fallback)
    return false;
  double a, b;
  return !(boost::conversion::try_lexical_convert(value, a) &&
           boost::conversion::try_lexical_convert(fallback, b) && a == b);
}

/** The names of the entries of a section that have not their default. */
std::vector<std::string> changed_entries(const Json &section)
{
  std::vector<std::string> names;
  if (section.is_object())
    for (const auto &[name, entry] : section.items())
      if (entry.contains("value") && is_changed(entry))
        names.push_back("'" + name + "'");
  return names;
}

/** Those of @p entries that have not their default. */
std::vector<std::string> changed_among(const Json &section,
                                       const std::vector<std::string> &entries)
{
  std::vector<std::string> names;
  for (const std::string &name : entries)
    if (is_changed(section[name]))
      names.push_back("'" + name + "'");
  return names;
}

std::string sentence(const std::vector<std::string> &entries,
                     const std::string &section,
                     const std::string &choice,
                     const std::string &chosen)
{
  return boost::algorithm::join(entries, ", ") + " in '" + section +
         (entries.size() == 1 ? "' has" : "' have") + " no effect, since '" +
         choice + "' is '" + chosen + "'.";
}
} // namespace

std::vector<std::string> unused_settings(const dealii::ParameterHandler &prm)
{
  std::stringstream text;
  prm.print_parameters(text,
                       dealii::ParameterHandler::JSON |
                           dealii::ParameterHandler::KeepDeclarationOrder);
  const Json all = Json::parse(text);

  std::vector<std::string> sentences;
  const auto add = [&](const std::vector<std::string> &entries,
                       const std::string &section, const std::string &choice,
                       const std::string &chosen) {
    if (!entries.empty())
      sentences.push_back(sentence(entries, section, choice, chosen));
  };
  // Sections that are named as what can be chosen: all but the chosen one.
  const auto look_beside = [&](const std::string &parent,
                               const std::string &choice,
                               const std::string &chosen) {
    for (const auto &[name, section] : all[parent].items())
      if (name != chosen)
        add(changed_entries(section), parent + "/" + name, choice, chosen);
  };
  const std::string generator = all["Packing"]["Generator"]["value"];
  look_beside("Packing", "Packing/Generator", generator);
  // With the forces of an earlier run no formulation is used at all, and the
  // file is that of the earlier run.
  if (all["Forces from"]["value"] == "")
    look_beside("Solver", "Formulation", all["Formulation"]["value"]);

  const std::string accuracy = all["Accuracy"]["value"];
  if (accuracy != "fine")
    add(changed_entries(all["Stress"]), "Stress", "Accuracy", accuracy);

  for (const Use &use : uses)
  {
    if (use.section.size() > 1 && use.section[1] != generator)
      continue;
    const Json *section = &all;
    for (const std::string &name : use.section)
      section = &(*section)[name];
    const std::string path = boost::algorithm::join(use.section, "/");
    const std::string chosen = (*section)[use.choice]["value"];
    if (chosen != use.value)
      add(changed_among(*section, use.entries), path, path + "/" + use.choice,
          chosen);
  }
  return sentences;
}
} // namespace Voussoir
