// SPDX-License-Identifier: LGPL-2.1-or-later

// The laws of friction and their entries: what a law says of the interfaces is
// the same in other terms, an angle of friction for a coefficient; values of
// pairs of groups count; only one law lets joints open as they slide or not;
// and an angle that is none is refused.

#include <voussoir/contact/friction_parameters.h>

#include "tests.h"

namespace test_friction_laws
{
using namespace Voussoir;

Strengths strengths(const Packing<2> &packing, const std::string &settings)
{
  FrictionParameters friction;
  dealii::ParameterHandler prm;
  friction.add_parameters(prm);
  prm.parse_input_from_string("subsection Friction\n" + settings + "\nend\n");
  return friction.strengths(packing);
}

double distance(const std::vector<double> &a, const std::vector<double> &b)
{
  double largest = a.size() == b.size() ? 0. : 1e300;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
    largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

void run()
{
  const Packing<2> packing = wall(4, 4);
  const Strengths tresca = strengths(packing, "set Strength = 1 + y");
  check("Tresca has no coefficient", tresca.coefficient.empty());
  check("  and is associated", tresca.dilate);

  const std::string dry = "set Coefficient = 1\nset Cohesion = 0.2 + x\n";
  const Strengths sliding = strengths(packing, dry + "set Law = Coulomb");
  const Strengths opening =
      strengths(packing, dry + "set Law = associated Coulomb");
  check("Coulomb's joints slide without opening", !sliding.dilate);
  check("  and associated ones open", opening.dilate);
  check("  with the same strengths",
        sliding.of_interface == opening.of_interface &&
            sliding.coefficient == opening.coefficient);

  const Strengths by_angle =
      strengths(packing, "set Law = Mohr-Coulomb\nset Cohesion = 0.2 + x\n"
                         "set Friction angle = 45");
  check_error("an angle of 45 degrees is a coefficient of one",
              distance(by_angle.coefficient, opening.coefficient), 1e-15);
  check("  with the same cohesion",
        by_angle.of_interface == opening.of_interface && by_angle.dilate);
  const Strengths by_direction =
      strengths(packing, "set Law = Mohr-Coulomb\n"
                         "set Friction angle = abs(ny) > 0.5 ? 30 : 0");
  double error = 0.;
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
    error = std::max(error,
                     std::abs(by_direction.coefficient[e] -
                              (std::abs(packing.interfaces()[e].normal[1]) > 0.5
                                   ? 1. / std::sqrt(3.)
                                   : 0.)));
  check_error("one for bed joints and another for head joints", error, 1e-15);

  show_refusal([&] {
    strengths(packing, "set Law = Mohr-Coulomb\nset Friction angle = 90");
  });
  show_refusal([&] {
    strengths(packing, "set Law = Mohr-Coulomb\nset Friction angle = -1");
  });
}

const RoomTest test("friction_laws", run);
} // namespace test_friction_laws
