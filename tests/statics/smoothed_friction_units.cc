// SPDX-License-Identifier: LGPL-2.1-or-later

// Neither units nor the smoothing length change the nondimensional forces:
// lengths, stresses and eps times 1e-6 and 1e6, with either kind of contact.

#include "tests.h"

using namespace Voussoir;

/** Forces over (stress x length), of a packing that slides in places. */
std::vector<double> nondimensional_forces(const std::string &settings,
                                          const double length,
                                          const double stress)
{
  const Scene scene =
      scene_under_stress(random_packing(200, 1, {{0., 0.}, {length, length}}),
                         0.3 * stress, stress * tensor(-1.2, 0.1, 0.1, -0.8));
  const InterfaceForces forces = Solver(settings).forces(scene);
  std::vector<double> all = forces.normal;
  all.insert(all.end(), forces.tangential.begin(), forces.tangential.end());
  for (double &f : all)
    f /= length * stress;
  return all;
}

int main()
{
  for (const std::string &contact : {compliant, hard})
  {
    const std::vector<double> reference =
        nondimensional_forces(contact, 1., 1.);
    const auto compare = [&](const std::string &what,
                             const std::vector<double> &forces) {
      double error = 0.;
      for (unsigned int k = 0; k < reference.size(); ++k)
        error = std::max(error, std::abs(forces[k] - reference[k]));
      check_error(what, error, 1e-8);
    };
    std::cout << contact << std::endl;
    for (const double factor : {1e-6, 1e6})
    {
      std::ostringstream eps;
      eps << "\nset Smoothing length = " << factor;
      compare("  lengths", nondimensional_forces(contact, factor, 1.));
      compare("  stresses", nondimensional_forces(contact, 1., factor));
      compare("  both", nondimensional_forces(contact, factor, factor));
      compare("  eps", nondimensional_forces(contact + eps.str(), 1., 1.));
    }
  }

  // eps is the unit of displacement.
  const Scene scene = shear_wall(2.);
  const DiscreteProblem problem(scene);
  for (const std::string &contact : {compliant, hard})
  {
    const auto u = Solver(contact).solve(problem).displacement;
    const auto v = Solver(contact + "\nset Smoothing length = 1e3")
                       .solve(problem)
                       .displacement;
    double error = 0.;
    for (unsigned int c = 0; c < u.size(); ++c)
      error = std::max(error, (v[c] / 1e3 - u[c]).norm() / (1. + u[c].norm()));
    check_error("displacements in proportion to eps", error, 1e-12);
  }
}
