// SPDX-License-Identifier: LGPL-2.1-or-later

// The semicircular arch of n straight-sided voussoirs under its weight, on two
// supports: the least strength that carries it, s_T / (gamma R), is known, and
// does not depend on the thickness. Each formulation carries it just above and
// proves the collapse just below.

#include <voussoir/packing/generators/arch.h>
#include <voussoir/scene/proofs/reactions.h>
#include <voussoir/scene/supports.h>

#include "tests.h"

namespace test_arch_limit
{
using namespace Voussoir;

/** A semicircle of mean radius R on its springings, weight gamma. */
Scene arch(const unsigned int n,
           const double R,
           const double thickness,
           const double gamma,
           const double strength)
{
  ArchGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.set("Mean radius", R);
  prm.set("Thickness", thickness);
  prm.set("Voussoirs", static_cast<long int>(n));
  Packing<2> packing(generator.generate("", Terminal::silent()));
  packing.support(boundary_edges_where(packing, "ny < -0.99 && y < 1e-9", ""));
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  loads.body = BodyForce(packing, [&](const dealii::Point<2> &, unsigned int) {
    return dealii::Tensor<1, 2>({0., -gamma});
  });
  const std::vector<double> strengths(packing.interfaces().size(), strength);
  return Scene(std::move(packing), strengths, std::move(loads));
}

void run()
{
  // The limits have six digits.
  const double margin = 1e-5;
  const std::vector<std::pair<unsigned int, double>> limits = {
      {10, 0.314904}, {20, 0.323986}, {40, 0.325531}, {100, 0.326224}};
  const double R = 3., gamma = 20.;
  for (const auto &[n, limit] : limits)
    for (const double thickness : {0.1 * R, 1.2 * R})
      for (const Method &method : all_methods)
      {
        const std::string name = std::to_string(n) + " voussoirs, thickness " +
                                 (thickness < R ? "0.1" : "1.2") + " R, " +
                                 method.name + ": ";
        const Scene stands =
            arch(n, R, thickness, gamma, (1. + margin) * limit * gamma * R);
        const DiscreteProblem problem = discretise(stands);
        const Solution found = Solver(method, 1e-8).solve(problem);
        check(name + "carried above", !found.mechanism);
        if (!found.mechanism)
        {
          const InterfaceForces forces = dimensional_forces(problem, found);
          const Certificate certificate = certify(stands, forces);
          check_error(name + "residual and violation",
                      std::max(certificate.equilibrium_residual,
                               certificate.admissibility_violation),
                      1e-7);
          check_error(
              name + "reaction",
              balance_on_ground(stands, reactions(stands, forces)).imbalance,
              1e-7);
        }
        const Scene falls =
            arch(n, R, thickness, gamma, (1. - margin) * limit * gamma * R);
        const Solution mechanism =
            Solver(method, 1e-8).solve(discretise(falls));
        check(name + "collapse below",
              mechanism.mechanism &&
                  certify_mechanism(falls,
                                    dimensional_motion(discretise(falls),
                                                       *mechanism.mechanism))
                          .work_over_dissipation > 1.);
      }
}

const RoomTest test("arch_limit", run);
} // namespace test_arch_limit
