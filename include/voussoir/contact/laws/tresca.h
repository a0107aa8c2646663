// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_contact_laws_tresca_h
#define voussoir_contact_laws_tresca_h

#include <voussoir/contact/joint_quantity.h>
#include <voussoir/contact/laws/friction_law.h>

namespace Voussoir
{
/** |f_e^t| <= s_e |e|, whatever the pressure (paper, eq. 2). */
class Tresca : public FrictionLaw
{
public:
  std::string name() const override { return "Tresca"; }
  std::string meaning() const override
  {
    return "|f_t| <= s_T |e|, whatever the pressure.";
  }
  std::string entries() const override { return "Strength, Pair strengths"; }
  void add_parameters(dealii::ParameterHandler &prm) override;
  Strengths strengths(const JointMeans &means) const override;

private:
  JointQuantity strength = {"strength", "Friction", "1",
                            "Strength", "",         "Pair strengths"};
};
} // namespace Voussoir

#endif
