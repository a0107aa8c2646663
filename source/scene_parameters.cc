// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameter_tree.h>
#include <voussoir/scene_parameters.h>

#include <utility>

namespace Voussoir
{
void SceneParameters::add_parameters(dealii::ParameterHandler &prm,
                                     const std::set<std::string> &cases)
{
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
  load_cases.add_parameters(prm, cases);
  friction.add_parameters(prm);
  contact.add_parameters(prm);
}

Packing SceneParameters::read_packing(const std::filesystem::path &directory,
                                      Terminal &terminal) const
{
  Packing blocks = packing.make_packing(directory, blocks_turn, terminal);
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

Given SceneParameters::given(Packing blocks,
                             const bool with_live_loads,
                             Terminal &terminal) const
{
  Given given = {std::move(blocks), {}, {}, {}};
  given.strengths = friction.strengths(given.packing);
  contact.add_strengths(given.packing, given.strengths);
  if (load_cases.forgotten())
    terminal.warning("There are 'Load cases', and none of them acts; set "
                     "'Loads/Combination', as in 1.35 dead + 1.5 lorry.");
  given.loads = loads.loads(given.packing);
  load_cases.add_combination("Loads", given.packing, given.loads);
  if (with_live_loads)
  {
    given.live_loads = live_loads.loads(given.packing);
    load_cases.add_combination("Live loads", given.packing, given.live_loads);
  }
  for (const auto &warnings : {given.strengths.warnings, given.loads.warnings,
                               given.live_loads.warnings})
    for (const std::string &warning : warnings)
      terminal.warning(warning);
  return given;
}

Scene SceneParameters::scene_of(Given given) const
{
  Scene scene(std::move(given.packing), std::move(given.strengths.of_interface),
              std::move(given.loads),
              blocks_turn ? rotations() : translations());
  scene.coefficient = std::move(given.strengths.coefficient);
  scene.dilates = given.strengths.dilate;
  scene.tensile_strength = std::move(given.strengths.tensile);
  scene.compressive_strength = std::move(given.strengths.compressive);
  return scene;
}

Scene SceneParameters::scene_at(Given given, const double factor) const
{
  given.loads.add(factor, given.live_loads);
  return scene_of(std::move(given));
}

Scene SceneParameters::live_scene_of(Given given) const
{
  std::swap(given.loads, given.live_loads);
  return scene_of(std::move(given));
}
} // namespace Voussoir
