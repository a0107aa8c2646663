// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_contact_friction_h
#define voussoir_contact_friction_h

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
   * the interface, not negative; S. With Coulomb's friction c_e, the mean of
   * the cohesion.
   */
  std::vector<double> of_interface;
  /** mu_e of each, the mean of mu over the interface; empty for Tresca. */
  std::vector<double> coefficient = {};
  /** Scene::dilates. */
  bool dilate = true;
  /** f_t of each, the mean; S. Empty if all are zero; see ContactParameters. */
  std::vector<double> tensile = {};
  /** f_c of each, the mean, or infinite; S. Empty if all are infinite. */
  std::vector<double> compressive = {};
  /** Warnings to the user on means that are not exact. */
  std::vector<std::string> warnings;
};

/**
 * The section `Friction`: the law of friction of the interfaces, those to the
 * ground among them, and its parameters.
 */
class FrictionParameters
{
public:
  /** The law that bounds |f_e^t|. */
  enum class Law
  {
    /** s_e |e|. */
    tresca,
    /** c_e |e| - mu_e f_e^n. */
    coulomb,
    /** c_e |e| - mu_e f_e^n, where joints open by mu_e times the sliding. */
    associated_coulomb
  };

  /** Declare the section and bind it. */
  void add_parameters(dealii::ParameterHandler &prm);

  /**
   * The strengths of the interfaces of @p packing against sliding.
   *
   * @throws InputError as means() does.
   */
  Strengths strengths(const Packing &packing) const;

private:
  Law law = Law::tresca;
  std::string strength = "1", pair_strengths;
  std::string coefficient = "0.6", pair_coefficients;
  std::string cohesion = "0", pair_cohesions;
};
} // namespace Voussoir

#endif
