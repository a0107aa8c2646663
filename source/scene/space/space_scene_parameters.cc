// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameter_tree.h>
#include <voussoir/base/text.h>
#include <voussoir/scene/space/space_scene_parameters.h>

#include <deal.II/base/patterns.h>

#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
namespace
{
SpaceScene scene_with(std::shared_ptr<const SpaceBlocks> blocks,
                      const SpaceLoadParameters &parameters,
                      Terminal &terminal)
{
  std::vector<std::string> warnings;
  SpaceLoads loads = parameters.loads(blocks->packing, warnings);
  for (const std::string &warning : warnings)
    terminal.warning(warning);
  return SpaceScene(std::move(blocks), std::move(loads));
}
} // namespace

void SpaceSceneParameters::add_parameters(dealii::ParameterHandler &prm)
{
  prm.add_parameter(
      "Rotations", blocks_turn,
      "true: blocks also turn, so that moments are balanced, and touch at all "
      "vertices of an interface, so that its resultant has a place on it: "
      "walls and vaults may overturn. false: they slide only, as in the "
      "paper.",
      dealii::Patterns::Bool());
  packing.add_parameters(prm);
  supports.add_parameters(prm);
  loads.add_parameters(prm);
  live_loads.add_parameters(prm);
  friction.add_parameters(prm);
  contact.add_parameters(prm);
  prm.enter_subsection("Contact");
  prm.add_parameter(
      "Friction cells", friction_cells,
      "The number n: where blocks turn each corner of an interface has n x n "
      "cells, at the centroids of which friction without pressure acts, that "
      "is Tresca's and cohesion. What these bear is borne by the interface; "
      "more cells show more of it: the strength of a square in torsion is 0.92 "
      "of the true one with 1, 0.98 with 2, 0.99 with 4. Coulomb's friction is "
      "exact without.",
      dealii::Patterns::Integer(1, 16));
  prm.leave_subsection();
}

std::string
SpaceSceneParameters::packing_key(const nlohmann::ordered_json &tree)
{
  std::string key;
  for (const char *name : {"Rotations", "Packing", "Supports"})
    key += values_in(tree.at(name));
  return key;
}

Packing<3>
SpaceSceneParameters::read_packing(const std::filesystem::path &directory,
                                   Terminal &terminal) const
{
  return supports.support(
      packing.make_packing(directory, blocks_turn, terminal));
}

std::shared_ptr<const SpaceBlocks>
SpaceSceneParameters::blocks(Packing<3> of, Terminal &terminal) const
{
  Strengths strengths = friction.strengths(of);
  contact.add_strengths(of, strengths);
  for (const std::string &warning : strengths.warnings)
    terminal.warning(warning);
  return std::make_shared<const SpaceBlocks>(
      std::move(of), std::move(strengths),
      blocks_turn ? rotations_in_space() : translations_in_space(),
      friction_cells);
}

SpaceScene SpaceSceneParameters::scene_of(std::shared_ptr<const SpaceBlocks> of,
                                          Terminal &terminal) const
{
  return scene_with(std::move(of), loads, terminal);
}

SpaceScene
SpaceSceneParameters::live_scene_of(std::shared_ptr<const SpaceBlocks> of,
                                    Terminal &terminal) const
{
  return scene_with(std::move(of), live_loads, terminal);
}
} // namespace Voussoir
