// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/mechanism.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/**
 * By how much, relative to the size of its terms, the work must exceed the
 * dissipation for the difference not to be rounding.
 */
constexpr double rounding_margin = 1e-12;
} // namespace

std::optional<Mechanism> find_mechanism(const DiscreteProblem &problem,
                                        const std::vector<double> &u)
{
  const auto normalise = [](std::vector<double> &v) {
    double largest = 0.;
    for (const double component : v)
      largest = std::max(largest, std::abs(component));
    if (!(largest > 0.) || !std::isfinite(largest))
      return false;
    for (double &component : v)
      component /= largest;
    return true;
  };

  std::vector<double> v = u;
  if (!normalise(v) || problem.joints().empty())
    return {};

  // [x_c] . n_e is the distance d_e between the centres.
  double dilation = 0.;
  for (const DiscreteProblem::Joint &joint : problem.joints())
    dilation = std::max(dilation,
                        -problem.jump(joint, v.data()).normal / joint.distance);
  for (unsigned int c = 0; c < problem.n_cells(); ++c)
    for (unsigned int i = 0; i < 2; ++i)
      v[problem.dof(c, i)] += dilation * problem.centres()[c][i];
  if (!normalise(v))
    return {};

  Mechanism mechanism;
  mechanism.work = problem.work(v.data());
  mechanism.dissipation = 0.;
  for (const DiscreteProblem::Joint &joint : problem.joints())
    mechanism.dissipation +=
        joint.strength * std::abs(problem.jump(joint, v.data()).tangential);

  double size_of_terms = mechanism.dissipation;
  for (unsigned int c = 0; c < problem.n_cells(); ++c)
    for (unsigned int i = 0; i < 2; ++i)
      size_of_terms += std::abs(problem.loads()[c][i] * v[problem.dof(c, i)]);
  if (!(mechanism.work - mechanism.dissipation >
        rounding_margin * size_of_terms))
    return {};

  mechanism.displacement.resize(problem.n_cells());
  for (unsigned int c = 0; c < problem.n_cells(); ++c)
    for (unsigned int i = 0; i < 2; ++i)
      mechanism.displacement[c][i] = v[problem.dof(c, i)];
  return mechanism;
}
} // namespace Voussoir
