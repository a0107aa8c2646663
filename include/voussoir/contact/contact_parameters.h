// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_contact_contact_parameters_h
#define voussoir_contact_contact_parameters_h

#include <voussoir/contact/joint_quantity.h>
#include <voussoir/contact/strengths.h>
#include <voussoir/packing/packing.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace Voussoir
{
/** The section `Contact`: what the interfaces carry across themselves. */
class ContactParameters
{
public:
  /** Declare the section and bind it. */
  void add_parameters(dealii::ParameterHandler &prm);

  /**
   * Add the tensile and compressive strengths of the interfaces of @p packing
   * to those against sliding.
   *
   * @throws InputError as means() does; or naming the interface whose tension
   *   is beyond what Coulomb's friction admits.
   */
  template <int dim>
  void add_strengths(const Packing<dim> &packing, Strengths &strengths) const;

private:
  JointQuantity tensile = {
      "tensile strength", "Contact", "0",
      "Tensile strength", "",        "Pair tensile strengths"};
  JointQuantity compressive = {
      "compressive strength",       "Contact", "",  "Compressive strength", "",
      "Pair compressive strengths", true,      true};
};
} // namespace Voussoir

#endif
