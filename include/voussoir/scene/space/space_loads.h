// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_space_space_loads_h
#define voussoir_scene_space_space_loads_h

#include <voussoir/packing/polyhedra/packing.h>
#include <voussoir/scene/space/space_scene.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** The section `Loads` in space, or another one of the same entries. */
class SpaceLoadParameters
{
public:
  /** @param name of the section. */
  explicit SpaceLoadParameters(const std::string &name = "Loads") : name(name)
  {}

  /** Declare the section and bind it. */
  void add_parameters(dealii::ParameterHandler &prm);

  /**
   * The loads on @p packing, whose supports must have been chosen. Tractions
   * and body forces are integrated over faces and cells with their moments.
   *
   * @param warnings on integrals that are not exact are added.
   * @throws InputError naming the place if a value is not a finite number or
   *   varies too fast; if a formula cannot be parsed or a vector has not three
   *   components, the uniform stress is not symmetric, a place is in no cell,
   * or a name is that of no cell.
   */
  SpaceLoads loads(const Packing<3> &packing,
                   std::vector<std::string> &warnings) const;

private:
  enum class Kind
  {
    traction,
    uniform_stress
  };

  void add_tractions(const Packing<3> &packing,
                     SpaceLoads &loads,
                     std::vector<std::string> &warnings) const;
  void add_body_forces(const Packing<3> &packing,
                       SpaceLoads &loads,
                       std::vector<std::string> &warnings) const;
  void add_cell_forces(const Packing<3> &packing, SpaceLoads &loads) const;

  std::string name;
  Kind kind = Kind::traction;
  std::string traction = "0; 0; 0";
  std::string stress = "0, 0, 0; 0, 0, 0; 0, 0, 0";
  std::string loaded_where = "1";
  std::string body = "0; 0; 0";
  std::string body_of_groups;
  std::string cell_forces;
};
} // namespace Voussoir

#endif
