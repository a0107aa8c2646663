// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/energy/yielding_joint.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Voussoir
{
namespace
{
/** The rows of a joint between blocks that turn, before the tangential one. */
constexpr unsigned int start = 0, end = 1, middle = 2;
constexpr unsigned int n_ends = 2, n_contacts_with_middle = 3;

/** True if joint @p e of a problem crushes between blocks that turn. */
bool has_section(const DiscreteProblem &problem, const unsigned int e)
{
  return problem.n_contacts(e) == n_ends && !problem.normal_limits().empty() &&
         std::isfinite(problem.normal_limits()[e].crushing);
}
} // namespace

Structure with_middle(const DiscreteProblem &problem)
{
  Structure::Part part;
  part.kinematics = problem.kinematics();
  part.loads = problem.loads();
  for (unsigned int b = 0; b < problem.n_bodies(); ++b)
    part.centres.push_back(problem.centre(b));
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    std::vector<ContactRow> rows = problem.rows(e);
    if (has_section(problem, e))
      rows.insert(rows.begin() + middle,
                  combination(0.5, rows[start], 0.5, rows[end]));
    part.joints.add(problem.joints()[e], rows, part.kinematics);
  }
  return Structure(ProcessGroup(), std::move(part));
}

std::vector<double> without_middle(const DiscreteProblem &problem,
                                   const std::vector<double> &forces)
{
  std::vector<double> kept;
  kept.reserve(problem.n_all_rows());
  auto of = forces.begin();
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    kept.insert(kept.end(), of, of + problem.n_contacts(e));
    of += problem.n_contacts(e) + (has_section(problem, e) ? 1 : 0);
    kept.push_back(*of++);
  }
  return kept;
}

void YieldingJoint::find_forces(const unsigned int e,
                                const double *jumps,
                                double *forces) const
{
  const unsigned int n = structure.n_contacts(e);
  std::fill_n(forces, n, 0.);
  if (is_section(e))
  {
    const Section::Forces found = section(e).forces(jumps[start], jumps[end]);
    forces[start] = found.at_start;
    forces[end] = found.at_end;
  }
  else
    for (unsigned int k = 0; k < n; ++k)
      forces[k] = std::clamp(problem.contact_stiffness(e) * jumps[k], least(e),
                             most(e));
  const double limit = structure.limit(e);
  forces[n] =
      std::clamp(structure.joints()[e].stiffness() * jumps[n], -limit, limit);
}

bool YieldingJoint::find_second_derivatives(const unsigned int e,
                                            const double *jumps,
                                            double *second) const
{
  const unsigned int n = structure.n_contacts(e);
  std::fill_n(second, n, 0.);
  if (is_section(e))
  {
    const Section::Stiffness found =
        section(e).stiffness(jumps[start], jumps[end]);
    second[start] = found.at_start - found.mixed;
    second[end] = found.at_end - found.mixed;
    second[middle] = 4. * found.mixed;
  }
  else
    for (unsigned int k = 0; k < n; ++k)
    {
      const double stiffness = problem.contact_stiffness(e);
      const double force = stiffness * jumps[k];
      second[k] = force < least(e) || force > most(e) ? 0. : stiffness;
    }
  const double stiffness = structure.joints()[e].stiffness();
  second[n] =
      std::abs(stiffness * jumps[n]) > structure.limit(e) ? 0. : stiffness;
  return is_isotropic(second, n);
}

bool YieldingJoint::is_section(const unsigned int e) const
{
  return structure.n_contacts(e) == n_contacts_with_middle;
}

Section YieldingJoint::section(const unsigned int e) const
{
  return Section(structure.joints()[e].stiffness(), problem.normal_limits()[e]);
}

double YieldingJoint::least(const unsigned int e) const
{
  return -problem.normal_limits()[e].crushing / problem.n_contacts(e);
}

double YieldingJoint::most(const unsigned int e) const
{
  return problem.tension(e) / problem.n_contacts(e);
}
} // namespace Voussoir
