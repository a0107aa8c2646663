// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/expression.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/friction.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace Voussoir
{
namespace
{
/** Exact for strengths that vary along a joint as polynomials up to degree 5.
 */
constexpr unsigned int n_quadrature_points = 3;
} // namespace

void FrictionParameters::add_parameters(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Friction");
  prm.add_parameter("Strength", strength,
                    "The Tresca strength s_T of the interfaces: the shear "
                    "stress at which they slide, whatever the normal stress. "
                    "A stress, not negative; an expression in x, y and the "
                    "unit normal nx, ny of the interface, whose sign is "
                    "arbitrary: abs(ny) > 0.5 ? 1 : 0.2 is one strength for "
                    "bed joints and another for head joints.");
  prm.leave_subsection();
}

std::vector<double> FrictionParameters::strengths(const Packing &packing) const
{
  const std::string name = "Friction/Strength";
  const Expression s_T(strength, {"x", "y", "nx", "ny"}, name);
  const dealii::QGauss<1> quadrature(n_quadrature_points);

  std::vector<double> strengths;
  strengths.reserve(packing.interfaces().size());
  for (const Packing::Interface &interface : packing.interfaces())
  {
    double mean = 0.;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      const dealii::Point<2> p =
          interface.start +
          quadrature.point(q)[0] * (interface.end - interface.start);
      const double value =
          s_T({p[0], p[1], interface.normal[0], interface.normal[1]});
      if (!std::isfinite(value) || value < 0.)
        throw InputError(
            text("'", name, "' = '", strength, "' is ", text_of_number(value),
                 " at ", text_of_point(p), ", on the interface of cells ",
                 interface.cell_minus, " and ", interface.cell_plus,
                 "; a strength must be finite and not negative."));
      mean += quadrature.weight(q) * value;
    }
    strengths.push_back(mean);
  }
  return strengths;
}
} // namespace Voussoir
