// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/mechanism.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
namespace
{
/**
 * By how much, relative to the size of its terms, the work must exceed the
 * dissipation for the difference not to be rounding.
 */
constexpr double rounding_margin = 1e-12;

/** The closing of a joint, relative to the largest displacement, that is none.
 */
constexpr double rounding_of_closing = 1e-13;

double largest_component(const std::vector<double> &v)
{
  double largest = 0.;
  for (const double component : v)
    largest = std::max(largest, std::abs(component));
  return largest;
}

/** @return whether that can be done. */
bool divide(std::vector<double> &v, const double divisor)
{
  if (!(divisor > 0.) || !std::isfinite(divisor))
    return false;
  for (double &component : v)
    component /= divisor;
  return true;
}

/**
 * Add to @p v as much of an opening as its closing joints need.
 *
 * @return how much; infinite if there is nothing that opens them.
 */
double open_joints(const DiscreteProblem &problem, std::vector<double> &v)
{
  double closing = 0.;
  for (const DiscreteProblem::Joint &joint : problem.joints())
    closing = std::max(closing, -problem.jump(joint, v.data()).normal);
  if (closing <= rounding_of_closing)
    return 0.;
  const std::vector<double> &opening = problem.opening();
  if (opening.empty())
    return std::numeric_limits<double>::infinity();

  double share = 0.;
  for (const DiscreteProblem::Joint &joint : problem.joints())
    share = std::max(share, -problem.jump(joint, v.data()).normal /
                                problem.jump(joint, opening.data()).normal);
  for (unsigned int k = 0; k < v.size(); ++k)
    v[k] += share * opening[k];
  return share;
}
} // namespace

std::optional<Mechanism> find_mechanism(const DiscreteProblem &problem,
                                        const std::vector<double> &u)
{
  std::vector<double> v = u;
  problem.remove_translations(v);
  if (!divide(v, largest_component(v)) || problem.joints().empty())
    return {};
  const double opening = open_joints(problem, v);
  if (!std::isfinite(opening))
    return {};
  problem.remove_translations(v);

  // A motion that the opening all but undoes is lost in rounding.
  const double remainder = largest_component(v) / (1. + opening);
  if (!divide(v, largest_component(v)))
    return {};

  Mechanism mechanism;
  mechanism.work = problem.work(v.data());
  mechanism.dissipation = 0.;
  for (const DiscreteProblem::Joint &joint : problem.joints())
    mechanism.dissipation +=
        joint.strength * std::abs(problem.jump(joint, v.data()).tangential);

  double size_of_terms = mechanism.dissipation;
  for (unsigned int b = 0; b < problem.n_bodies(); ++b)
    for (unsigned int i = 0; i < 2; ++i)
      size_of_terms += std::abs(problem.loads()[b][i] * v[problem.dof(b, i)]);
  if (!(mechanism.work - mechanism.dissipation >
        rounding_margin / remainder * size_of_terms))
    return {};

  mechanism.displacement = problem.displacement_of_cells(v, 1.);
  return mechanism;
}
} // namespace Voussoir
