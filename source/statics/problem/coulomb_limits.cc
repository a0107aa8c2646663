// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/statics/problem/coulomb_limits.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Voussoir
{
std::vector<double> limits_of_coulomb(const DiscreteProblem &problem,
                                      const std::vector<double> &forces)
{
  std::vector<double> limits;
  limits.reserve(problem.joints().size());
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const Structure::Joint &joint = problem.joints()[e];
    const auto first = forces.begin() + problem.first_row(e);
    if (problem.is_plane())
    {
      const double normal =
          std::accumulate(first, first + problem.n_contacts(e), 0.);
      limits.push_back(
          std::max(joint.strength - joint.coefficient * normal, 0.));
      continue;
    }
    problem.for_each_face_set(e, [&](const Structure::FaceSet &set) {
      if (set.size == 2)
        limits.push_back(set.strength);
      else if (set.size == 3)
        limits.push_back(
            joint.coefficient *
            std::max(problem.tension(e) * set.share - first[set.row], 0.));
    });
  }
  return limits;
}

std::vector<double> sizes_of_friction(const DiscreteProblem &problem,
                                      const std::vector<double> &forces)
{
  std::vector<double> sizes;
  sizes.reserve(problem.joints().size());
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const double *const of_joint = &forces[problem.first_row(e)];
    if (problem.is_plane())
      sizes.push_back(std::abs(of_joint[problem.n_contacts(e)]));
    else
      problem.for_each_face_set(e, [&](const Structure::FaceSet &set) {
        const double *const q = of_joint + set.row + set.size % 2;
        if (set.size > 1)
          sizes.push_back(std::hypot(q[0], q[1]));
      });
  }
  return sizes;
}

std::vector<double> pressures_of(const DiscreteProblem &problem,
                                 const std::vector<double> &forces)
{
  std::vector<double> pressures(forces.size(), 0.);
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const std::size_t first = problem.first_row(e);
    problem.for_each_pressure(e, [&](const unsigned int row, double) {
      pressures[first + row] = forces[first + row];
    });
  }
  return pressures;
}

double excess_of_friction(const DiscreteProblem &problem,
                          const std::vector<double> &forces)
{
  const std::vector<double> limits = limits_of_coulomb(problem, forces);
  const std::vector<double> sizes = sizes_of_friction(problem, forces);
  double excess = 0.;
  for (std::size_t k = 0; k < limits.size(); ++k)
    excess = std::max(excess, sizes[k] - limits[k]);
  return excess / std::max(1., largest_component(problem.loads()));
}
} // namespace Voussoir
