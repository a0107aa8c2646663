// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_friction_h
#define voussoir_scene_friction_h

#include <voussoir/packing/packing.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** The strengths of the interfaces. */
struct Strengths
{
  /**
   * s_e of each, in the order of Packing::interfaces(): the mean of s_T over
   * the interface, not negative; S.
   */
  std::vector<double> of_interface;
  /** Warnings to the user on means that are not exact. */
  std::vector<std::string> warnings;
};

/**
 * The section `Friction`: the Tresca strength s_T of the interfaces, those to
 * the ground among them.
 */
class FrictionParameters
{
public:
  /** Declare the section and bind it. */
  void add_parameters(dealii::ParameterHandler &prm);

  /**
   * The strengths of the interfaces of @p packing.
   *
   * @throws InputError naming the interface if a strength is negative or not a
   *   finite number, or varies too fast for its mean; if a formula cannot be
   *   parsed; or naming a pair of groups that does not exist, is given twice or
   *   meets nowhere.
   */
  Strengths strengths(const Packing &packing) const;

private:
  std::string strength = "1";
  std::string pair_strengths;
};
} // namespace Voussoir

#endif
