// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_contact_laws_coulomb_h
#define voussoir_contact_laws_coulomb_h

#include <voussoir/contact/joint_quantity.h>
#include <voussoir/contact/laws/friction_law.h>

namespace Voussoir
{
/** |f_e^t| <= c_e |e| - mu_e f_e^n; blocks slide along their joints. */
class Coulomb : public FrictionLaw
{
public:
  std::string name() const override { return "Coulomb"; }
  std::string meaning() const override
  {
    return "|f_t| <= c |e| + mu p with the compressive force p. Blocks slide "
           "along their joints; what carries is then not certain from forces "
           "alone, and what collapses is, if it is so with the next law.";
  }
  std::string entries() const override
  {
    return "Coefficient, Pair coefficients, Cohesion, Pair cohesions";
  }
  void add_parameters(dealii::ParameterHandler &prm) override;
  Strengths strengths(const JointMeans &means) const override;
  /** c_e of each interface, the mean; see means(). */
  std::vector<double> cohesions(const JointMeans &means,
                                std::vector<std::string> &warnings) const
  {
    return means(cohesion, warnings);
  }

private:
  JointQuantity coefficient = {"coefficient", "Friction", "0.6",
                               "Coefficient", "",         "Pair coefficients"};
  JointQuantity cohesion = {"cohesion", "Friction", "0",
                            "Cohesion", "",         "Pair cohesions"};
};

/** Coulomb's friction, where joints open by mu_e times the sliding. */
class AssociatedCoulomb : public FrictionLaw
{
public:
  /** @param coulomb has the entries; it must outlive this object. */
  explicit AssociatedCoulomb(const Coulomb &coulomb) : coulomb(coulomb) {}
  std::string name() const override { return "associated Coulomb"; }
  std::string meaning() const override
  {
    return "the same, where joints that slide open by mu times the sliding, so "
           "that the theorems of limit analysis hold.";
  }
  std::string entries() const override { return coulomb.entries(); }
  void add_parameters(dealii::ParameterHandler & /*prm*/) override {}
  Strengths strengths(const JointMeans &means) const override;

private:
  const Coulomb &coulomb;
};
} // namespace Voussoir

#endif
