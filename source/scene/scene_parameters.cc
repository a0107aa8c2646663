// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameter_tree.h>
#include <voussoir/scene/scene_parameters.h>

#include <utility>

namespace Voussoir
{
std::vector<std::string> SceneParameters::sections_of_users()
{
  return {load_cases_section, ties_section, fill_section};
}

void SceneParameters::add_parameters(dealii::ParameterHandler &prm,
                                     const NamedSections &names)
{
  const auto names_in = [&](const std::string &section) {
    const auto found = names.find(section);
    return found == names.end() ? std::set<std::string>() : found->second;
  };
  prm.add_parameter(
      "Rotations", blocks_turn,
      "true: blocks also turn, so that moments are balanced, and touch at both "
      "ends of an interface, so that its resultant has a place on it: arches "
      "and towers may overturn. false: they slide only, as in the paper.",
      dealii::Patterns::Bool());
  packing.add_parameters(prm);
  supports.add_parameters(prm);
  loads.add_parameters(prm);
  live_loads.add_parameters(prm);
  earthquake.add_parameters(prm);
  load_cases.add_parameters(prm, names_in(load_cases_section));
  friction.add_parameters(prm);
  contact.add_parameters(prm);
  ties.add_parameters(prm, names_in(ties_section));
  fill.add_parameters(prm, names_in(fill_section));
}

Packing<2> SceneParameters::read_packing(const std::filesystem::path &directory,
                                         Terminal &terminal) const
{
  Packing<2> blocks = packing.make_packing(directory, blocks_turn, terminal);
  for (const std::string &notice : blocks.notices())
    terminal.warning(notice);
  supports.support(blocks);
  return blocks;
}

std::string SceneParameters::packing_key(const nlohmann::ordered_json &tree)
{
  std::string key;
  for (const char *name : {"Rotations", "Packing", "Supports"})
    key += values_in(tree.at(name));
  return key;
}

SceneData SceneParameters::data(Packing<2> blocks,
                                const bool with_live_loads,
                                Terminal &terminal) const
{
  SceneData data = {std::move(blocks), {}, {}, {}, {}, {}};
  data.strengths = friction.strengths(data.packing);
  contact.add_strengths(data.packing, data.strengths);
  if (load_cases.forgotten())
    terminal.warning("There are 'Load cases', and none of them acts; set "
                     "'Loads/Combination', as in 1.35 dead + 1.5 lorry.");
  data.links = ties.links(data.packing);
  FillOnBlocks soil;
  if (!fill.empty())
    soil = fill.on(data.packing);
  data.loads = loads.loads(data.packing, soil.spreading);
  load_cases.add_combination("Loads", data.packing, data.loads, soil.spreading);
  if (with_live_loads)
  {
    data.live_loads = live_loads.loads(data.packing, soil.spreading);
    load_cases.add_combination("Live loads", data.packing, data.live_loads,
                               soil.spreading);
    if (!earthquake.empty())
      data.live_loads.add(1., earthquake.loads(data.packing, data.loads));
  }
  if (!fill.empty())
  {
    data.loads.add(1., soil.loads);
    data.links.insert(data.links.end(), soil.links.begin(), soil.links.end());
    data.fill_columns = std::move(soil.columns);
  }
  for (const auto &warnings :
       {data.strengths.warnings, data.loads.warnings, data.live_loads.warnings})
    for (const std::string &warning : warnings)
      terminal.warning(warning);
  return data;
}

Scene SceneParameters::scene_of(SceneData data) const
{
  Scene scene(std::move(data.packing), std::move(data.strengths.of_interface),
              std::move(data.loads), blocks_turn ? rotations() : translations(),
              std::move(data.links));
  scene.coefficient = std::move(data.strengths.coefficient);
  scene.dilates = data.strengths.dilate;
  scene.fill_columns = std::move(data.fill_columns);
  scene.friction_law = std::move(data.strengths.law);
  scene.tensile_strength = std::move(data.strengths.tensile);
  scene.compressive_strength = std::move(data.strengths.compressive);
  return scene;
}

Scene SceneParameters::scene_at(SceneData data, const double factor) const
{
  data.loads.add(factor, data.live_loads);
  return scene_of(std::move(data));
}

Scene SceneParameters::live_scene_of(SceneData data) const
{
  std::swap(data.loads, data.live_loads);
  data.links = without_rest(std::move(data.links)); // which is a dead load
  return scene_of(std::move(data));
}
} // namespace Voussoir
