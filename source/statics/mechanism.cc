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

/** Make the mean of @p v vanish in each connected group of cells. */
void remove_translations(const DiscreteProblem &problem, std::vector<double> &v)
{
  std::vector<dealii::Tensor<1, 2>> u(problem.n_cells());
  for (unsigned int c = 0; c < problem.n_cells(); ++c)
    for (unsigned int i = 0; i < 2; ++i)
      u[c][i] = v[problem.dof(c, i)];
  problem.remove_group_means(u);
  for (unsigned int c = 0; c < problem.n_cells(); ++c)
    for (unsigned int i = 0; i < 2; ++i)
      v[problem.dof(c, i)] = u[c][i];
}
} // namespace

std::optional<Mechanism> find_mechanism(const DiscreteProblem &problem,
                                        const std::vector<double> &u)
{
  std::vector<double> v = u;
  remove_translations(problem, v);
  if (!divide(v, largest_component(v)) || problem.joints().empty())
    return {};

  // [x_c] . n_e is the distance d_e between the centres.
  double dilation = 0.;
  for (const DiscreteProblem::Joint &joint : problem.joints())
    dilation = std::max(dilation,
                        -problem.jump(joint, v.data()).normal / joint.distance);
  for (unsigned int c = 0; c < problem.n_cells(); ++c)
    for (unsigned int i = 0; i < 2; ++i)
      v[problem.dof(c, i)] += dilation * problem.centres()[c][i];
  remove_translations(problem, v);

  // A motion that the dilation all but undoes is lost in rounding.
  const double remainder = largest_component(v) / (1. + dilation);
  if (!divide(v, largest_component(v)))
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
        rounding_margin / remainder * size_of_terms))
    return {};

  mechanism.displacement.resize(problem.n_cells());
  for (unsigned int c = 0; c < problem.n_cells(); ++c)
    for (unsigned int i = 0; i < 2; ++i)
      mechanism.displacement[c][i] = v[problem.dof(c, i)];
  return mechanism;
}
} // namespace Voussoir
