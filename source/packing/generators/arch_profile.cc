// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/packing/generators/arch_profile.h>
#include <voussoir/packing/generators/measures.h>

#include <utility>

namespace Voussoir
{
ArchProfile::ArchProfile(std::string section) : section(std::move(section)) {}

void ArchProfile::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  add_choice<bool>(
      prm, "Shape", pointed,
      {{false, "circular",
        "one arc around the origin, of 'Mean radius' and 'Embrace'.",
        "Mean radius, Embrace"},
       {true, "pointed",
        "two arcs from level springings, of 'Span' and 'Radius over "
        "span'.",
        "Span, Radius over span"}},
      "The middle line of the arch, which is symmetric to x = 0.");
  prm.add_parameter("Mean radius", mean_radius,
                    "Radius of the middle line of a circular arch; a length, "
                    "positive.",
                    Double(0.));
  prm.add_parameter("Embrace", embrace,
                    "Angle from springing to springing of a circular arch; "
                    "degrees, positive. 180 is a semicircle, less a segmental "
                    "arch.",
                    Double(0., 180.));
  prm.add_parameter("Span", span,
                    "Distance of the springings of a pointed arch, of its "
                    "middle line; a length, positive.",
                    Double(0.));
  prm.add_parameter("Radius over span", radius_over_span,
                    "Radius of the arcs of a pointed arch, of the middle line, "
                    "over 'Span'; 0.5 is a semicircle, 1 an equilateral arch.",
                    Double(0.5));
  prm.add_parameter("Thickness", thick,
                    "Distance from the intrados to the extrados; a length, "
                    "positive.",
                    Double(0.));
  prm.add_parameter("Voussoirs", n,
                    "Number of voussoirs along the whole arch; if it is odd, "
                    "there is a keystone at the crown.",
                    Integer(2, 1000000));
}

HalfArch ArchProfile::joints() const
{
  check_measures(section, {{"Thickness", thick}});
  if (pointed)
  {
    check_measures(section,
                   {{"Span", span}, {"Radius over span", radius_over_span}});
    return pointed_arch(section, span, radius_over_span, thick, n);
  }
  check_measures(section, {{"Mean radius", mean_radius}, {"Embrace", embrace}});
  return circular_arch(section, mean_radius, thick, n, embrace);
}
} // namespace Voussoir
