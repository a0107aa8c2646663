// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_contact_laws_mohr_coulomb_h
#define voussoir_contact_laws_mohr_coulomb_h

#include <voussoir/contact/laws/coulomb.h>

namespace Voussoir
{
/**
 * Coulomb's friction by its angle, as in soil and rock mechanics:
 * |f_e^t| <= c_e |e| - tan(phi_e) f_e^n, where joints open by tan(phi_e) times
 * the sliding.
 */
class MohrCoulomb : public FrictionLaw
{
public:
  /** @param coulomb has the cohesion; it must outlive this object. */
  explicit MohrCoulomb(const Coulomb &coulomb) : coulomb(coulomb) {}
  std::string name() const override { return "Mohr-Coulomb"; }
  std::string meaning() const override
  {
    return "associated Coulomb with mu = tan(phi), by the angle of friction "
           "phi.";
  }
  std::string entries() const override
  {
    return "Friction angle, Pair friction angles, Cohesion, Pair cohesions";
  }
  void add_parameters(dealii::ParameterHandler &prm) override;
  /** @throws InputError as means() does, or if an angle is not below 90. */
  Strengths strengths(const JointMeans &means) const override;

private:
  const Coulomb &coulomb;
  JointQuantity angle = {"friction angle", "Friction", "30",
                         "Friction angle", "",         "Pair friction angles"};
};
} // namespace Voussoir

#endif
