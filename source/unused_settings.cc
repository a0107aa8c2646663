// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/unused_settings.h>

#include <boost/algorithm/string/join.hpp>
#include <nlohmann/json.hpp>

#include <sstream>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

/** The names of the entries of a section that have not their default. */
std::vector<std::string> changed_entries(const Json &section)
{
  std::vector<std::string> names;
  if (section.is_object())
    for (const auto &[name, entry] : section.items())
      if (entry.contains("value") && entry["value"] != entry["default_value"])
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
  // Of sections that are named as what can be chosen, those not chosen.
  const auto look_beside = [&](const std::string &parent,
                               const std::string &choice,
                               const std::string &chosen) {
    for (const auto &[name, section] : all[parent].items())
      if (name != chosen)
      {
        const std::vector<std::string> entries = changed_entries(section);
        if (!entries.empty())
          sentences.push_back(
              sentence(entries, parent + "/" + name, choice, chosen));
      }
  };
  look_beside("Packing", "Packing/Generator",
              all["Packing"]["Generator"]["value"]);
  look_beside("Solver", "Formulation", all["Formulation"]["value"]);

  const std::string accuracy = all["Accuracy"]["value"];
  const std::vector<std::string> of_fine = changed_entries(all["Stress"]);
  if (accuracy != "fine" && !of_fine.empty())
    sentences.push_back(sentence(of_fine, "Stress", "Accuracy", accuracy));
  return sentences;
}
} // namespace Voussoir
