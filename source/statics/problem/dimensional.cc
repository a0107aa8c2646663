// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/problem/dimensional.h>

#include <numeric>

namespace Voussoir
{
namespace
{
/** The unit of a force per unit thickness. */
double force_scale(const DiscreteProblem &problem)
{
  return problem.stress_scale() * problem.length_scale();
}
} // namespace

Motion dimensional_motion(const DiscreteProblem &problem,
                          const std::vector<double> &u,
                          const double unit)
{
  Motion motion(problem.n_cells(), problem.kinematics());
  if (u.empty())
    return motion;
  for (unsigned int c = 0; c < problem.n_cells(); ++c)
    for (unsigned int i = 0; i < 2; ++i)
      motion.displacement[c][i] = unit * u[problem.dof(c, i)];
  for (unsigned int c = 0; c < motion.rotation.size(); ++c)
    motion.rotation[c] = unit * u[problem.dof(c, 2)] / problem.length_scale();
  return motion;
}

Motion dimensional_motion(const DiscreteProblem &problem,
                          const Mechanism &mechanism)
{
  return dimensional_motion(problem, mechanism.u, 1.);
}

Motion dimensional_motion(const DiscreteProblem &problem,
                          const Solution &solution)
{
  return dimensional_motion(problem, solution.u, solution.displacement_unit);
}

std::vector<double> nondimensional_motion(const DiscreteProblem &problem,
                                          const Motion &motion,
                                          const double unit)
{
  std::vector<double> u(problem.n_dofs(), 0.);
  for (unsigned int c = 0; c < problem.n_cells(); ++c)
    for (unsigned int i = 0; i < 2; ++i)
      u[problem.dof(c, i)] = motion.displacement[c][i] / unit;
  for (unsigned int c = 0; c < motion.rotation.size(); ++c)
    u[problem.dof(c, 2)] = motion.rotation[c] * problem.length_scale() / unit;
  return u;
}

InterfaceForces dimensional_forces(const DiscreteProblem &problem,
                                   const Solution &solution)
{
  const double unit = force_scale(problem);
  InterfaceForces forces;
  if (solution.forces.empty())
    return forces;
  for (unsigned int e = 0; e < problem.n_interfaces(); ++e)
  {
    const unsigned int n = problem.n_contacts(e);
    const double *f = &solution.forces[problem.first_row(e)];
    forces.normal.push_back(unit * std::accumulate(f, f + n, 0.));
    forces.tangential.push_back(unit * f[n]);
    if (!problem.open_ends().empty())
    {
      const auto [start, end] = problem.open_ends()[e];
      forces.at_ends.push_back(
          {{start ? 0. : unit * f[0], end ? 0. : unit * f[start ? 0 : 1]}});
    }
    else if (n == 2)
      forces.at_ends.push_back({{unit * f[0], unit * f[1]}});
  }
  for (const LinkContact &link : problem.links())
    forces.in_links.push_back(
        unit *
        (link.has_joint()
             ? link.rest +
                   link.sign * solution.forces[problem.first_row(link.joint)]
             : link.rest));
  return forces;
}

std::vector<double> nondimensional_forces(const DiscreteProblem &problem,
                                          const InterfaceForces &forces)
{
  const double factor = 1. / force_scale(problem);
  std::vector<double> result;
  for (unsigned int e = 0; e < forces.normal.size(); ++e)
  {
    if (forces.at_ends.empty())
      result.push_back(factor * forces.normal[e]);
    else
      for (unsigned int k = 0; k < 2; ++k)
        if (problem.open_ends().empty() || !problem.open_ends()[e][k])
          result.push_back(factor * forces.at_ends[e][k]);
    result.push_back(factor * forces.tangential[e]);
  }
  for (unsigned int k = 0; k < problem.links().size(); ++k)
    if (const LinkContact &link = problem.links()[k]; link.has_joint())
    {
      result.push_back(link.sign * (factor * forces.in_links[k] - link.rest));
      result.push_back(0.);
    }
  return result;
}
} // namespace Voussoir
