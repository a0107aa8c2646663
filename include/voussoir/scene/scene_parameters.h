// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_scene_parameters_h
#define voussoir_scene_scene_parameters_h

#include <voussoir/base/parameters/named_sections.h>
#include <voussoir/contact/contact_parameters.h>
#include <voussoir/contact/friction_parameters.h>
#include <voussoir/packing/packing_parameters.h>
#include <voussoir/scene/links/fill.h>
#include <voussoir/scene/links/ties.h>
#include <voussoir/scene/loads/earthquake.h>
#include <voussoir/scene/loads/load_cases.h>
#include <voussoir/scene/loads/loads.h>
#include <voussoir/scene/scene.h>
#include <voussoir/scene/supports.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace Voussoir
{
/** A packing with what its interfaces carry, and the loads on it. */
struct SceneData
{
  /** The packing with its supports. */
  Packing<2> packing;
  /** Of its interfaces. */
  Strengths strengths;
  /** The loads that stay as they are. */
  Loads loads;
  /** The loads that a factor multiplies, if one is looked for. */
  Loads live_loads;
  /** Between its blocks, and to the ground. */
  std::vector<Link> links;
  /** Scene::fill_columns. */
  std::vector<std::array<dealii::Point<2>, 4>> fill_columns;
};

/** The entry `Rotations` and the sections that describe a scene. */
class SceneParameters
{
public:
  /** The sections in which users name the sections. */
  static std::vector<std::string> sections_of_users();
  /** Declare them, with those sections of users, and bind them. */
  void add_parameters(dealii::ParameterHandler &prm,
                      const NamedSections &names);

  /** Files that the packing is read from; paths start at @p directory. */
  auto input_files(const std::filesystem::path &directory) const
  {
    return packing.input_files(directory);
  }
  /**
   * Make the packing, with its supports. What it is made of stands in
   * packing_key(), too.
   *
   * @param directory where relative paths begin.
   * @param terminal sees what is noticed.
   * @throws InputError.
   */
  Packing<2> read_packing(const std::filesystem::path &directory,
                          Terminal &terminal) const;
  /**
   * The values of all entries that read_packing() looks at: where they are the
   * same, and the files are, so is the packing.
   *
   * @param tree all sections and entries, as tree_of() gives them.
   */
  static std::string packing_key(const nlohmann::ordered_json &tree);
  /**
   * Add the strengths and the loads to a packing with its supports.
   *
   * @param blocks the packing.
   * @param with_live_loads false to leave these out.
   * @param terminal sees what is noticed.
   * @throws InputError.
   */
  SceneData
  data(Packing<2> blocks, bool with_live_loads, Terminal &terminal) const;
  /** Take polygons as the packing; see PackingParameters::give(). */
  void give(PolygonList polygons) { packing.give(std::move(polygons)); }
  /** How the supports of @p packing move; see SupportParameters::motion(). */
  auto motion_of_supports(const Packing<2> &packing) const
  {
    return supports.motion(packing);
  }
  /** The scene with its loads, without the live ones. */
  Scene scene_of(SceneData data) const;
  /** The scene with the live loads times @p factor besides. */
  Scene scene_at(SceneData data, double factor) const;
  /** The scene with the live loads instead. */
  Scene live_scene_of(SceneData data) const;

private:
  bool blocks_turn = false;
  PackingParameters<2> packing;
  SupportParameters supports;
  LoadParameters loads;
  LoadParameters live_loads = LoadParameters("Live loads");
  LoadCases load_cases;
  Earthquake earthquake;
  Ties ties;
  Fill fill;
  FrictionParameters friction;
  ContactParameters contact;
};
} // namespace Voussoir

#endif
