// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/contact/laws/mohr_coulomb.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace Voussoir
{
void MohrCoulomb::add_parameters(dealii::ParameterHandler &prm)
{
  angle.add_parameters(
      prm,
      "The angle of friction phi of the interfaces, in degrees, "
      "not negative and below 90; an expression as for "
      "'Strength', of which the mean over an interface counts.",
      "Other angles of friction where two groups of cells meet, "
      "as for 'Pair strengths'.");
}

Strengths MohrCoulomb::strengths(const JointMeans &means) const
{
  Strengths result;
  result.of_interface = coulomb.cohesions(means, result.warnings);
  result.coefficient = means(angle, result.warnings);
  for (unsigned int e = 0; e < result.coefficient.size(); ++e)
  {
    double &of_interface = result.coefficient[e];
    if (!(of_interface < 90.))
      throw InputError(
          text("The angle of friction of the interface at ", means.place(e),
               " is ", of_interface,
               " degrees; it must be below 90. Lower 'Friction/Friction "
               "angle', or 'Friction/Pair friction angles'."));
    of_interface = std::tan(of_interface * dealii::numbers::PI / 180.);
  }
  return result;
}
} // namespace Voussoir
