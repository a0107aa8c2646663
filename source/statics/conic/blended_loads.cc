// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/statics/conic/blended_loads.h>
#include <voussoir/statics/problem/equilibrate.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/** The pressing force, over the largest load, and its part of what joints
 * crush at. */
constexpr double size_of_pressing = 1., part_of_crushing = 0.5;
/** Work, over the size of its terms, that is rounding. */
constexpr double rounding_of_work = 1e-12;

/** Forces of pressure, far from all limits but those against sliding. */
std::vector<double> pressing_forces_of(const DiscreteProblem &problem)
{
  const double largest = largest_component(problem.loads());
  const double usual = size_of_pressing * (largest > 0. ? largest : 1.);
  std::vector<double> forces(problem.n_all_rows(), 0.);
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    double force = usual;
    if (!problem.normal_limits().empty())
      force = std::min(force,
                       part_of_crushing * problem.normal_limits()[e].crushing);
    double *const of = &forces[problem.first_row(e)];
    problem.for_each_pressure(e,
                              [&](const unsigned int row, const double share) {
                                of[row] = -force * share;
                              });
  }
  return forces;
}
} // namespace

BlendedLoads::BlendedLoads(const DiscreteProblem &problem)
    : problem(problem), of_rows(problem),
      pressing_forces(pressing_forces_of(problem))
{
  std::vector<double> loads_of_pressing = problem.loads();
  add(loads_of_pressing, -1., imbalance(problem, pressing_forces));
  std::vector<double> difference = problem.loads();
  add(difference, -1., loads_of_pressing);
  of_share = {of_rows.loads(loads_of_pressing, true),
              of_rows.loads(difference, false), 1.};
}

std::vector<double> BlendedLoads::forces_of_all(const std::vector<double> &x,
                                                const double share) const
{
  std::vector<double> forces = of_rows.rows().forces_of(x);
  for (std::size_t k = 0; k < forces.size(); ++k)
    forces[k] = pressing_forces[k] + (forces[k] - pressing_forces[k]) / share;
  return forces;
}

bool BlendedLoads::collapse(const FactorMotion &motion,
                            const double bound) const
{
  double of_terms = 0., of_loads = 0.;
  for (std::size_t k = 0; k < motion.u.size(); ++k)
  {
    const double load = of_share.live[k] + of_share.dead[k];
    of_terms += std::abs(load * motion.u[k]);
    of_loads += std::abs(load);
  }
  return dot(of_share.live, motion.u) * (1. - bound) >
         rounding_of_work * of_terms +
             motion.closing * largest_component(motion.u) * of_loads;
}
} // namespace Voussoir
