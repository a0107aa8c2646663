// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_contact_friction_parameters_h
#define voussoir_contact_friction_parameters_h

#include <voussoir/contact/laws/friction_law.h>

#include <memory>
#include <vector>

namespace Voussoir
{
/**
 * The section `Friction`: the law of friction of the interfaces, those to the
 * ground among them, and its parameters.
 */
class FrictionParameters
{
public:
  /** With all laws. */
  FrictionParameters();

  /** Declare the section and bind it. */
  void add_parameters(dealii::ParameterHandler &prm);

  /** FrictionLaw::strengths() of the law that was chosen, with its name. */
  template <int dim>
  Strengths strengths(const Packing<dim> &packing) const;

private:
  std::vector<std::unique_ptr<FrictionLaw>> laws;
  unsigned int chosen = 0;
};
} // namespace Voussoir

#endif
