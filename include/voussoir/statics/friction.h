// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_friction_h
#define voussoir_statics_friction_h

#include <voussoir/packing/packing.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Voussoir
{
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
   * The strength s_e of each interface, in the order of Packing::interfaces();
   * S. It is the mean of s_T over the interface, not negative.
   *
   * @throws InputError naming the interface if a strength is negative or not a
   *   finite number, or varies too fast for its mean; if a formula cannot be
   *   parsed; or naming a pair of groups that does not exist, is given twice or
   *   meets nowhere.
   */
  std::vector<double> strengths(const Packing &packing) const;

private:
  std::string strength = "1";
  std::string pair_strengths;
};
} // namespace Voussoir

#endif
