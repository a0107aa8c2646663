// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_loads_loads_h
#define voussoir_scene_loads_loads_h

#include <voussoir/packing/packing.h>
#include <voussoir/scene/loads/body_force.h>
#include <voussoir/scene/loads/cell_forces.h>
#include <voussoir/scene/loads/resultant.h>
#include <voussoir/scene/loads/segment_tractions.h>
#include <voussoir/scene/loads/vehicle.h>

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** All that acts on a packing, in the user's units. */
struct Loads
{
  /** g_e on each boundary edge; a stress, tension positive. */
  std::vector<dealii::Tensor<1, 2>> traction;
  /** The body force, without that of on_cells. */
  BodyForce body;
  /** The forces on cells, name by name. */
  std::vector<CellForce> on_cells;
  /** EdgeTractions::first_moment of the traction, or empty if it is zero. */
  std::vector<dealii::Tensor<1, 2>> traction_moment = {};
  /** Warnings to the user on integrals that are not exact. */
  std::vector<std::string> warnings = {};
  /**
   * What the user asked for, added up from the input before anything is put on
   * edges and cells, about reference_point(); none where loads are not from
   * parameters.
   */
  std::optional<Resultant> requested = {};

  /** Add @p factor times other loads on the same packing, their warnings too.*/
  void add(double factor, const Loads &other);
};

/** The point about which the moments of loads are added up; a length. */
inline const dealii::Point<2> &reference_point(const Packing<2> &packing)
{
  return packing.vertex(0, 0);
}

/** Nothing that acts on @p packing, as it was asked for. */
Loads no_loads(const Packing<2> &packing);

/** The section `Loads`, or another one of the same entries. */
class LoadParameters
{
public:
  /**
   * @param name of the section.
   * @param parent the section that it is in; empty if it is in none.
   */
  explicit LoadParameters(const std::string &name = "Loads",
                          const std::string &parent = "")
      : name(name), section(parent.empty() ? name : parent + "/" + name)
  {}

  /** Declare the section, in its parent, and bind it. */
  void add_parameters(dealii::ParameterHandler &prm);

  /**
   * The loads on @p packing, whose supports must have been chosen. The traction
   * g_e is the mean of g over an edge.
   *
   * @param soil on it that spreads the loads of vehicles.
   * @throws InputError naming the place if a value is not a finite number or
   *   varies too fast for its mean; if a formula cannot be parsed, the uniform
   *   stress is not symmetric, a place is on no edge, a line on no boundary, or
   *   a name is that of no cell; as VehicleParameters::forces().
   */
  Loads loads(const Packing<2> &packing,
              const std::vector<Spreading> &soil = {}) const;

private:
  enum class Kind
  {
    traction,
    uniform_stress
  };

  void add_tractions(const Packing<2> &packing, Loads &loads) const;
  void add_uniform_stress(const Packing<2> &packing,
                          const std::vector<bool> &chosen,
                          EdgeTractions &tractions,
                          Loads &loads) const;

  std::string name;
  /** Its path. */
  std::string section;
  Kind kind = Kind::traction;
  std::string traction = "0; 0";
  std::string stress = "0, 0; 0, 0";
  std::string loaded_where = "1";
  std::string on_segments;
  std::string body = "0; 0";
  std::string body_of_groups;
  std::string cell_forces;
  VehicleParameters vehicle;
};
} // namespace Voussoir

#endif
