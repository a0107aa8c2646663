// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/joint_law.h>
#include <voussoir/algebra/linear/joint_system.h>
#include <voussoir/algebra/vectors.h>
#include <voussoir/statics/problem/equilibrate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace Voussoir
{
using Joint = DiscreteProblem::Joint;

namespace
{
/** An error, nondimensional, that is rounding. */
constexpr double rounding_of_error = 1e-15;
/** The ratio of the errors of two rounds below which another follows. */
constexpr double worthwhile_correction = 0.5;
constexpr unsigned int n_max_rounds = 30;

/** An error, nondimensional, that is small enough. */
constexpr double small_error = 1e-13;
/**
 * Distances of friction from a limit that falls with the pressure, over the
 * error of the forces, tried in turn until the error is small: a correction may
 * take pressure away from a joint that slides, and is the larger the more
 * joints do.
 */
constexpr std::array<double, 3> margins = {{1e1, 1e3, 1e5}};
/** The refinements of a correction, for the shift and the rounding in it. */
constexpr unsigned int n_refinements = 2;

/** The largest shift whose error in the balance the refinements remove. */
constexpr double largest_correction_shift = 1.;

/** The forces of one joint beside its limits. */
struct OfJoint
{
  OfJoint(const DiscreteProblem &problem,
          const unsigned int e,
          const std::vector<double> &forces)
      : joint(problem.joints()[e]),
        most(problem.tension(e) / problem.n_contacts(e))
  {
    const std::size_t first = problem.first_row(e);
    for (unsigned int r = 0; r < problem.n_contacts(e); ++r)
    {
      normal += forces[first + r];
      excess = std::max(excess, forces[first + r] - most);
    }
    tangential = forces[first + problem.n_contacts(e)];
    strength = std::max(joint.strength - joint.coefficient * normal, 0.);
  }
  const Joint &joint;
  /** The largest tension of a contact. */
  const double most;
  /** Of a contact, beyond that. */
  double excess = 0.;
  double normal = 0., tangential = 0.;
  /** With what friction gains by pressure. */
  double strength;
};

/** The largest force that is missing to a balance, or beyond its limit. */
double error(const DiscreteProblem &problem, const std::vector<double> &forces)
{
  std::vector<double> left = imbalance(problem, forces);
  left.resize(problem.n_judged_dofs());
  double largest = largest_component(left);
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const OfJoint of(problem, e, forces);
    largest =
        std::max({largest, of.excess, std::abs(of.tangential) - of.strength});
  }
  return largest;
}

void move_into_limits(const DiscreteProblem &problem,
                      const double margin,
                      std::vector<double> &forces)
{
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const unsigned int n = problem.n_contacts(e);
    double *of_joint = &forces[problem.first_row(e)];
    const double most = problem.tension(e) / n;
    for (unsigned int r = 0; r < n; ++r)
      of_joint[r] = std::min(of_joint[r], most);
    const OfJoint of(problem, e, forces);
    const double strength = of.joint.coefficient > 0.
                                ? std::max(of.strength - margin, 0.)
                                : of.strength;
    of_joint[n] = std::clamp(of.tangential, -strength, strength);
  }
}

/** (|e|/d_e) w_e, which turns a jump into a force. */
JointStiffnesses weighted_stiffnesses(const DiscreteProblem &problem,
                                      const std::vector<double> &forces,
                                      const double ample)
{
  JointStiffnesses stiffness = {std::vector<double>(forces.size()), true};
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const OfJoint of(problem, e, forces);
    const unsigned int n = problem.n_contacts(e);
    const std::size_t first = problem.first_row(e);
    const auto weight = [&](const double slack, const double share) {
      return std::min(1., slack / (ample * of.joint.length * share));
    };
    for (unsigned int r = 0; r < n; ++r)
      stiffness.of_rows[first + r] =
          problem.contact_stiffness(e) *
          weight(of.most - forces[first + r], 1. / n);
    stiffness.of_rows[first + n] =
        of.joint.stiffness() *
        weight(of.strength - std::abs(of.tangential), 1.);
    stiffness.are_isotropic &= is_isotropic(&stiffness.of_rows[first], n);
  }
  return stiffness;
}

/** Add the smallest correction that balances; false if rounding prevents it. */
bool correct(const DiscreteProblem &problem,
             JointSystem &system,
             std::vector<double> &forces,
             const double ample)
{
  const JointStiffnesses stiffness =
      weighted_stiffnesses(problem, forces, ample);
  double shift = least_shift;
  while (!system.prepare(stiffness, shift))
    if ((shift *= factor_of_shift) > largest_correction_shift)
      return false;
  for (unsigned int k = 0; k <= n_refinements; ++k)
  {
    // Bodies move the way that they are pushed, and joints push back.
    const std::vector<double> u = system.solve(imbalance(problem, forces));
    const std::vector<double> jumps = problem.jumps(u);
    for (std::size_t k = 0; k < forces.size(); ++k)
      forces[k] += stiffness.of_rows[k] * jumps[k];
  }
  return true;
}
/** The best forces met so far, and their error. */
struct Best
{
  std::vector<double> forces;
  double error;
};

/** Move forces to @p margin below their limits, and correct, while it helps. */
void repeat(const DiscreteProblem &problem,
            JointSystem &system,
            const double ample,
            const double margin,
            Best &best)
{
  std::vector<double> trial = best.forces;
  double before = std::numeric_limits<double>::infinity();
  for (unsigned int k = 0; k < n_max_rounds && best.error > rounding_of_error;
       ++k)
  {
    move_into_limits(problem, margin, trial);
    if (!correct(problem, system, trial, ample))
      break;
    const double now = error(problem, trial);
    if (now < best.error)
      best = {trial, now};
    if (!(now < worthwhile_correction * before))
      break;
    before = now;
  }
}
} // namespace

std::vector<double> imbalance(const DiscreteProblem &problem,
                              const std::vector<double> &forces)
{
  std::vector<double> sum(problem.n_dofs());
  problem.add_jump_gradients(-1., forces, sum);
  for (unsigned int k = 0; k < sum.size(); ++k)
    sum[k] += problem.loads()[k];
  return sum;
}

std::vector<double> equilibrate(const DiscreteProblem &problem,
                                const std::vector<double> &forces,
                                const double ample)
{
  Best best = {forces, error(problem, forces)};
  if (problem.joints().empty() || !(best.error > rounding_of_error))
    return forces;

  JointSystem system(problem, LinearSolver::automatic);
  repeat(problem, system, ample, 0., best);
  if (std::any_of(problem.joints().begin(), problem.joints().end(),
                  [](const Joint &joint) { return joint.coefficient > 0.; }))
    for (const double margin : margins)
      if (best.error > small_error)
        repeat(problem, system, ample, margin * best.error, best);
  return best.forces;
}
} // namespace Voussoir
