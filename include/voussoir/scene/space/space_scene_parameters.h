// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_space_space_scene_parameters_h
#define voussoir_scene_space_space_scene_parameters_h

#include <voussoir/contact/contact_parameters.h>
#include <voussoir/contact/friction_parameters.h>
#include <voussoir/packing/polyhedra/packing_parameters.h>
#include <voussoir/scene/space/space_loads.h>
#include <voussoir/scene/space/space_scene.h>
#include <voussoir/scene/space_supports.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

namespace Voussoir
{
/** The entry `Rotations` and the sections that describe a scene in space. */
class SpaceSceneParameters
{
public:
  /** Declare them and bind them. */
  void add_parameters(dealii::ParameterHandler &prm);

  /** Files that the packing is read from; paths start at @p directory. */
  auto input_files(const std::filesystem::path &directory) const
  {
    return packing.input_files(directory);
  }
  /** Take blocks as the packing; see PackingParameters::give(). */
  void give(BlockMeshes blocks) { packing.give(std::move(blocks)); }
  /**
   * The values of all entries that read_packing() looks at: where they are the
   * same, and the files are, so is the packing.
   *
   * @param tree all sections and entries, as tree_of() gives them.
   */
  static std::string packing_key(const nlohmann::ordered_json &tree);
  /**
   * Make the packing, with its supports. What it is made of stands in
   * packing_key(), too.
   *
   * @param directory where relative paths begin.
   * @param terminal sees what is noticed.
   * @throws InputError.
   */
  Packing<3> read_packing(const std::filesystem::path &directory,
                          Terminal &terminal) const;
  /**
   * The blocks with the strengths of their interfaces.
   *
   * @throws InputError.
   */
  std::shared_ptr<const SpaceBlocks> blocks(Packing<3> packing,
                                            Terminal &terminal) const;
  /** @{ */
  /** The scene with the loads that stay as they are, and with the live ones. */
  SpaceScene scene_of(std::shared_ptr<const SpaceBlocks> blocks,
                      Terminal &terminal) const;
  SpaceScene live_scene_of(std::shared_ptr<const SpaceBlocks> blocks,
                           Terminal &terminal) const;
  /** @} */

  /** How the supports of @p packing move; see SupportDisplacements::motion().
   */
  auto motion_of_supports(const Packing<3> &packing) const
  {
    return supports.motion(packing);
  }

private:
  bool blocks_turn = false;
  unsigned int friction_cells = 1;
  PackingParameters<3> packing;
  SpaceSupports supports;
  SpaceLoadParameters loads;
  SpaceLoadParameters live_loads = SpaceLoadParameters("Live loads");
  FrictionParameters friction;
  ContactParameters contact;
};
} // namespace Voussoir

#endif
