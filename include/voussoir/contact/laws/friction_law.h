// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_contact_laws_friction_law_h
#define voussoir_contact_laws_friction_law_h

#include <voussoir/contact/joint_quantity.h>
#include <voussoir/contact/strengths.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace Voussoir
{
/**
 * A law of friction: what the user says of it in the section `Friction`, and
 * the forces that follow. They are those of JointLimits, |f_e^t| at most
 * s_e |e| - mu_e f_e^n with s_e and mu_e not negative.
 */
class FrictionLaw
{
public:
  virtual ~FrictionLaw() = default;
  /** Its name in a .prm file. */
  virtual std::string name() const = 0;
  /** Its documentation, behind its name and a colon. */
  virtual std::string meaning() const = 0;
  /** The entries that it looks at, separated by commas. */
  virtual std::string entries() const = 0;
  /** Declare the entries that no law before it has. */
  virtual void add_parameters(dealii::ParameterHandler &prm) = 0;
  /**
   * The strengths of interfaces against sliding, by the @p means over them.
   *
   * @throws InputError as means() does.
   */
  virtual Strengths strengths(const JointMeans &means) const = 0;
};
} // namespace Voussoir

#endif
