// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_loads_h
#define voussoir_scene_loads_h

#include <voussoir/packing/packing.h>
#include <voussoir/scene/body_force.h>
#include <voussoir/scene/segment_tractions.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/** A force on each of some cells, which acts evenly over the area of each. */
struct CellForce
{
  /** The name that the user gave the cells. */
  std::string name;
  /** Their numbers, ascending. */
  std::vector<unsigned int> cells;
  /** On each cell; per unit thickness. */
  dealii::Tensor<1, 2> force;
  /** The torque about x_c of the place where it acts; per unit thickness. */
  double torque = 0.;
};

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

  /** Add @p factor times other loads on the same packing, their warnings too.*/
  void add(double factor, const Loads &other);
};

/** The section `Loads`, or another one of the same entries. */
class LoadParameters
{
public:
  /** @param section its name. */
  explicit LoadParameters(std::string section = "Loads")
      : section(std::move(section))
  {}

  /** Declare the section and bind it. */
  void add_parameters(dealii::ParameterHandler &prm);

  /**
   * The loads on @p packing, whose supports must have been chosen. The traction
   * g_e is the mean of g over an edge.
   *
   * @throws InputError naming the place if a value is not a finite number or
   *   varies too fast for its mean; if a formula cannot be parsed, the uniform
   *   stress is not symmetric, a place is on no edge, a line on no boundary, or
   *   a name is that of no cell.
   */
  Loads loads(const Packing &packing) const;

private:
  enum class Kind
  {
    traction,
    uniform_stress
  };

  EdgeTractions tractions(const Packing &packing,
                          std::vector<std::string> &warnings) const;
  void add_traction_of_expression(const Packing &packing,
                                  const std::vector<bool> &chosen,
                                  EdgeTractions &tractions,
                                  std::vector<std::string> &warnings) const;
  void add_uniform_stress(const Packing &packing,
                          const std::vector<bool> &chosen,
                          EdgeTractions &tractions) const;
  BodyForce body_force(const Packing &packing,
                       std::vector<std::string> &warnings) const;
  std::vector<CellForce> forces_on_cells(const Packing &packing) const;

  std::string section;
  Kind kind = Kind::traction;
  std::string traction = "0; 0";
  std::string stress = "0, 0; 0, 0";
  std::string loaded_where = "1";
  std::string on_segments;
  std::string body = "0; 0";
  std::string cell_forces;
};
} // namespace Voussoir

#endif
