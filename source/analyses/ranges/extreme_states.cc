// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/analyses/ranges/extreme_states.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/random.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/problem/discretise.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/** The number of vertices in random directions. */
constexpr unsigned int n_random = 24;
/** Of forces of order one: what is none, and no difference of them. */
constexpr double no_force = 1e-8;
} // namespace

ExtremeStates::ExtremeStates(const Scene &scene,
                             const StatePolytope &polytope,
                             const unsigned int seed)
    : scene(scene), polytope(polytope), states(scene), program(states.program())
{
  add_random(seed);
  leave_limits();
  find_varying();
  find_limits();
}

void ExtremeStates::add(const ForceFunction &function)
{
  const GreatestValue value = states.greatest(program, function);
  if (!value.is_bounded())
    throw InputError("'Ranges/Samples' asks for states of equal probability, "
                     "and some forces have no bound: they balance by "
                     "themselves. Let fewer edges be supports, or set "
                     "'Ranges/Samples = 0'.");
  found.push_back(nondimensional_forces(polytope.problem(), value.forces));
}

void ExtremeStates::add_random(const unsigned int seed)
{
  Random random(seed);
  for (unsigned int k = 0; k < n_random; ++k)
  {
    ForceFunction function;
    for (unsigned int e = 0; e < polytope.problem().joints().size(); ++e)
    {
      const double start = random.normal(), end = random.normal();
      function.terms.push_back(
          {e, {{start, scene.turns() ? end : start}}, random.normal()});
    }
    add(function);
  }
}

double ExtremeStates::largest_room(const StatePolytope::Limit &limit) const
{
  double largest = 0.;
  for (const auto &x : found)
    largest = std::max(largest, polytope.room(limit, x));
  return largest;
}

void ExtremeStates::leave_limits()
{
  for (const StatePolytope::Limit &limit : polytope.limits())
    if (largest_room(limit) < no_force)
      add({{{limit.joint,
             {{-limit.outward[0], -limit.outward[limit.n_rows - 2]}},
             -limit.outward[limit.n_rows - 1]}}});
}

std::vector<double> ExtremeStates::middle() const
{
  std::vector<double> mean(polytope.n_forces(), 0.);
  for (const auto &x : found)
    Voussoir::add(mean, 1. / found.size(), x);
  return mean;
}

void ExtremeStates::find_varying()
{
  std::vector<double> least = found[0], greatest = found[0];
  for (const auto &x : found)
    for (std::size_t r = 0; r < x.size(); ++r)
    {
      least[r] = std::min(least[r], x[r]);
      greatest[r] = std::max(greatest[r], x[r]);
    }
  for (std::size_t r = 0; r < least.size(); ++r)
    varying.push_back(greatest[r] - least[r] > no_force);
}

void ExtremeStates::find_limits()
{
  for (const StatePolytope::Limit &limit : polytope.limits())
  {
    bool varies = false;
    for (unsigned int r = 0; r < limit.n_rows; ++r)
      varies |= limit.outward[r] != 0. && varying[limit.first + r];
    if (!varies)
      continue;
    if (largest_room(limit) < no_force)
    {
      const Packing<2>::Interface &i = scene.packing.interfaces()[limit.joint];
      throw SolverError(text(
          "The friction of the interface from ", text_of_point(i.start), " to ",
          text_of_point(i.end),
          " is at its limit in all states, whose forces differ: there is no "
          "way from one to the next for 'Ranges/Samples'. Set 'Ranges/Samples "
          "= 0', or change the load a little."));
    }
    cutting.push_back(limit);
  }
}

unsigned int ExtremeStates::dimension() const
{
  const DiscreteProblem &problem = polytope.problem();
  const unsigned int n = problem.n_unknowns();
  std::vector<bool> is_moved(problem.n_dofs(), false);
  const unsigned int n_varying =
      std::count(varying.begin(), varying.end(), true);
  for (std::size_t r = 0; r < varying.size(); ++r)
  {
    if (!varying[r])
      continue;
    const unsigned int e = problem.joint_of_row(r);
    const ContactRow row = problem.row(r);
    for (const unsigned int body :
         {problem.joints()[e].cell_minus, problem.joints()[e].cell_plus})
      for (unsigned int i = 0; i < n && !problem.is_held(body); ++i)
        if (i >= problem.n_translations() ||
            std::abs(row.direction[i]) > no_force)
          is_moved[problem.dof(body, i)] = true;
  }
  const unsigned int n_balances =
      std::count(is_moved.begin(), is_moved.end(), true);
  return n_varying == 0 ? 0 : std::max(n_varying, n_balances + 1) - n_balances;
}
} // namespace Voussoir
