// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/ranges/state_polytope.h>
#include <voussoir/statics/problem/discretise.h>

namespace Voussoir
{
namespace
{
bool has_friction(const Structure::Joint &joint)
{
  return joint.strength > 0. || joint.coefficient > 0.;
}

/** The problem with friction of any size where there is some. */
DiscreteProblem without_limits(const DiscreteProblem &problem)
{
  std::vector<double> limits;
  for (const auto &joint : problem.joints())
    limits.push_back(has_friction(joint) ? 1. : 0.);
  return problem.with_tresca(limits);
}
} // namespace

StatePolytope::StatePolytope(const Scene &scene)
    : unlimited(without_limits(discretise(scene)))
{
  const DiscreteProblem limited = discretise(scene);
  for (unsigned int e = 0; e < limited.joints().size(); ++e)
  {
    const Structure::Joint &joint = limited.joints()[e];
    const unsigned int n_contacts = limited.n_contacts(e);
    Limit limit = {e, limited.first_row(e), n_contacts + 1, {{0., 0., 0.}}, 0.};
    for (unsigned int k = 0; k < n_contacts; ++k)
    {
      limit.outward = {{0., 0., 0.}};
      limit.outward[k] = 1.;
      all_limits.push_back(limit);
    }
    if (!has_friction(joint))
      continue;
    limit.value = joint.strength;
    for (const double sign : {1., -1.})
    {
      for (unsigned int k = 0; k < n_contacts; ++k)
        limit.outward[k] = joint.coefficient;
      limit.outward[n_contacts] = sign;
      all_limits.push_back(limit);
    }
  }
}
} // namespace Voussoir
