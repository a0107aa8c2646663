// SPDX-License-Identifier: LGPL-2.1-or-later

// Loads at 1 - 10^-k and 1 + 10^-k of the limit, k = 1...8, where the limit is
// known: below, the forces balance the load or the answer is refused, above,
// the collapse is proven or the answer is refused; never the other way round.
// All but the centres, whose forces lie in the interior that vanishes at the
// limit, answer always.

#include <voussoir/packing/generators/arch.h>
#include <voussoir/scene/supports.h>

#include "judgement.h"
#include "room.h"

namespace test_limit_loads
{
using namespace Voussoir;

/** Turned squares slide along their joints at d = s_T. */
Scene sliding_squares(const double d)
{
  return scene_under_stress(turned_squares(12), 0.3,
                            tensor(-1 + d, 0, 0, -1 - d));
}

/** The semicircular arch of 10 voussoirs; see statics/arch_limit. */
Scene arch(const double strength)
{
  ArchGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.set("Mean radius", 1.);
  prm.set("Thickness", 0.1);
  prm.set("Voussoirs", 10L);
  Packing<2> packing(generator.generate("", Terminal::silent()));
  packing.support(boundary_edges_where(packing, "ny < -0.99 && y < 1e-9", ""));
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  loads.body = BodyForce(packing, [](const dealii::Point<2> &, unsigned int) {
    return dealii::Tensor<1, 2>({0., -1.});
  });
  const std::vector<double> strengths(packing.interfaces().size(), strength);
  return Scene(std::move(packing), strengths, std::move(loads));
}

/** @p scene_at gives the scene at a multiple of the limit load. */
void approach(const std::string &name,
              const std::function<Scene(double)> &scene_at,
              const int n_digits)
{
  std::cout << name << std::endl;
  for (const Method &method : all_methods)
    for (int k = 1; k <= n_digits; ++k)
      for (const double sign : {-1., 1.})
      {
        const Judgement found =
            judge(scene_at(1. + sign * std::pow(10., -k)), method);
        const Verdict right = sign < 0. ? Verdict::carried : Verdict::collapse;
        const std::string load =
            std::string(sign < 0. ? "1 - 1e-" : "1 + 1e-") + std::to_string(k);
        check("  " + method.name + " at " + load + ": not wrong",
              found.verdict == right || (found.verdict == Verdict::refused &&
                                         !found.message.empty()));
        if (method.formulation != "analytic centre" || sign > 0. || k <= 5)
          check("  " + method.name + " at " + load + ": answered",
                found.verdict == right);
      }
}

void run()
{
  approach(
      "shear wall", [](const double load) { return shear_wall(1. / load); }, 8);
  approach(
      "turned squares",
      [](const double load) { return sliding_squares(0.3 * load); }, 8);
  // This limit has six digits.
  approach(
      "arch", [](const double load) { return arch(0.314904 / load); }, 5);
}

const RoomTest test("limit_loads", run);
} // namespace test_limit_loads
