// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/joint_law.h>
#include <voussoir/algebra/linear/joint_system.h>
#include <voussoir/algebra/vectors.h>
#include <voussoir/statics/problem/find_opening.h>
#include <voussoir/statics/problem/mechanism.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
/**
 * The margin, relative to the size of its terms, by which the work must exceed
 * the dissipation for the difference not to be rounding.
 */
constexpr double rounding_margin = 1e-12;

/**
 * The closing of a joint, relative to the largest displacement, that is
 * rounding.
 */
constexpr double rounding_of_closing = 1e-13;

/** A closing that is worth correcting where the supports clamp the packing. */
constexpr double closing_to_correct = 0.1;
/** The shift of that correction, relative to stiffnesses of one. */
constexpr double holding_shift = 1e-8;
constexpr unsigned int n_rounds = 10;

/**
 * The jumps, relative to the largest displacement, that may be those of joints
 * that do not move in a mechanism that a solver has nearly found.
 */
constexpr double small_jumps[] = {1e-3, 1e-4, 1e-5, 1e-6};

/** @return false if @p divisor is not positive and finite. */
bool divide(std::vector<double> &v, const double divisor)
{
  if (!std::isfinite(divisor) || divisor <= 0.)
    return false;
  for (double &component : v)
    component /= divisor;
  return true;
}

/** The closing of a joint in @p v that closes most; not negative. */
double largest_closing(const DiscreteProblem &problem,
                       const std::vector<double> &v)
{
  double closing = 0.;
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    closing = std::max(closing, -problem.opening(e, v.data()));
  return closing;
}

/**
 * Move @p v to the nearest displacement in which joints whose jumps are below
 * @p small have none: contacts that hardly open, or close, neither close nor
 * open, and joints that hardly slide do not. If it is negative, these are the
 * contacts that close more than that.
 *
 * @return true if no joint closes then.
 */
bool round_small_jumps(const DiscreteProblem &problem,
                       const double small,
                       std::vector<double> &v)
{
  JointStiffnesses springs = {std::vector<double>(problem.n_all_rows(), 0.),
                              false};
  JointSystem system(problem, LinearSolver::automatic);
  for (unsigned int round = 0; round < n_rounds; ++round)
  {
    const double limit = round == 0 ? small : -rounding_of_closing;
    std::vector<double> right(problem.n_dofs(), 0.);
    std::vector<double> forces = problem.jumps(v);
    springs.are_isotropic = true;
    for (unsigned int e = 0; e < problem.joints().size(); ++e)
    {
      const unsigned int n = problem.n_contacts(e);
      const double *jumps = &forces[problem.first_row(e)];
      double *of_rows = &springs.of_rows[problem.first_row(e)];
      for (unsigned int r = 0; r < n; ++r)
        if (jumps[r] < limit)
          of_rows[r] = problem.contact_stiffness(e);
      if (std::abs(jumps[n]) < limit)
        of_rows[n] = problem.joints()[e].stiffness();
      springs.are_isotropic &= is_isotropic(of_rows, n);
    }
    problem.multiply_by_blocks(springs.of_rows, forces);
    problem.add_jump_gradients(-1., forces, right);
    if (!system.prepare(springs, holding_shift))
      return false;
    const std::vector<double> correction = system.solve(right);
    for (unsigned int k = 0; k < v.size(); ++k)
      v[k] += correction[k];
    if (largest_closing(problem, v) <= rounding_of_closing)
      return true;
  }
  return false;
}

/**
 * The same in a packing that has no opening, of what closes: between supports
 * that clamp the packing joints can do nothing else in a mechanism.
 */
bool keep_joints_closed(const DiscreteProblem &problem, std::vector<double> &v)
{
  return largest_closing(problem, v) <= closing_to_correct &&
         problem.work(v.data()) > dissipation_of(problem, v.data()) &&
         round_small_jumps(problem, -rounding_of_closing, v);
}

/**
 * Add to @p v as much of an opening as its closing joints need.
 *
 * @return the multiple of the opening; infinite if there is nothing that opens
 *   them.
 */
double open_joints(const DiscreteProblem &problem, std::vector<double> &v)
{
  const double closing = largest_closing(problem, v);
  if (closing == 0.)
    return 0.;
  const std::vector<double> &opening = opening_of(problem).displacement;
  if (opening.empty())
    return closing <= rounding_of_closing || keep_joints_closed(problem, v)
               ? 0.
               : std::numeric_limits<double>::infinity();

  double share = 0.;
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    for (unsigned int r = 0; r < problem.n_contacts(e); ++r)
      share = std::max(share, -problem.jump(e, r, v.data()) /
                                  problem.jump(e, r, opening.data()));
  for (unsigned int k = 0; k < v.size(); ++k)
    v[k] += share * opening[k];
  return share;
}
/**
 * The mechanism @p v, which closes no joint, if its work is beyond rounding.
 *
 * @param opening the part of an opening in it.
 */
std::optional<Mechanism> mechanism_of(const DiscreteProblem &problem,
                                      std::vector<double> v,
                                      const double opening)
{
  problem.remove_rigid_motions(v);
  // A motion that the opening all but undoes is lost in rounding.
  const double remainder = largest_component(v) / (1. + opening);
  if (!divide(v, largest_component(v)))
    return {};

  Mechanism mechanism;
  mechanism.work = problem.work(v.data());
  mechanism.dissipation = dissipation_of(problem, v.data());
  double size_of_terms = mechanism.dissipation;
  for (unsigned int k = 0; k < problem.n_dofs(); ++k)
    size_of_terms += std::abs(problem.loads()[k] * v[k]);
  if (!(mechanism.work - mechanism.dissipation >
        rounding_margin / remainder * size_of_terms))
    return {};

  mechanism.u = std::move(v);
  return mechanism;
}

/** Scale a displacement; false if it is none. */
bool normalise(const DiscreteProblem &problem, std::vector<double> &v)
{
  problem.remove_rigid_motions(v);
  return divide(v, largest_component(v)) && !problem.joints().empty();
}
} // namespace

double negative_part(const double a, const double b)
{
  const double least = std::min(a, b), greatest = std::max(a, b);
  if (least >= 0.)
    return 0.;
  return greatest <= 0. ? -0.5 * (a + b)
                        : 0.5 * least * (least / (greatest - least));
}

double dissipation_of(const DiscreteProblem &problem, const double *const u)
{
  double sum = 0.;
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const double mu = problem.joints()[e].coefficient,
                 tension = problem.tension(e),
                 limit = problem.limit(e) - mu * tension,
                 sliding = std::abs(problem.sliding(e, u));
    if (std::isfinite(limit))
      sum += limit * sliding;
    const unsigned int n = problem.n_contacts(e);
    if (problem.normal_limits().empty() || n == 0)
      continue;
    const double start = problem.jump(e, 0, u), end = problem.jump(e, n - 1, u);
    sum += tension * 0.5 * (start + end);
    // Joints with a coefficient open as they slide.
    if (const double crushing = problem.normal_limits()[e].crushing;
        std::isfinite(crushing))
      sum += (tension + crushing) *
             negative_part(start - mu * sliding, end - mu * sliding);
  }
  return sum;
}

std::optional<Mechanism> find_mechanism(const DiscreteProblem &problem,
                                        const std::vector<double> &u)
{
  std::vector<double> v = u;
  if (!normalise(problem, v))
    return {};
  const double opening = open_joints(problem, v);
  return std::isfinite(opening) ? mechanism_of(problem, v, opening)
                                : std::nullopt;
}

std::optional<Mechanism> find_mechanism_near(const DiscreteProblem &problem,
                                             const std::vector<double> &u)
{
  std::vector<double> rough = u;
  if (!normalise(problem, rough))
    return {};
  for (const double small : small_jumps)
  {
    std::vector<double> v = rough;
    if (!round_small_jumps(problem, small, v))
      continue;
    if (auto found = mechanism_of(problem, v, 0.))
      return found;
  }
  return {};
}
} // namespace Voussoir
