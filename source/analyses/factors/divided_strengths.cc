// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/analyses/factors/changed_strengths.h>
#include <voussoir/analyses/factors/divided_strengths.h>
#include <voussoir/base/text.h>
#include <voussoir/scene/proofs/certificate.h>
#include <voussoir/scene/proofs/space_certificate.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/problem/discretise.h>
#include <voussoir/statics/problem/discretise_space.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
/** The divisor with which there are none. */
constexpr double without_strengths = std::numeric_limits<double>::infinity();
/** The largest step of log f. */
constexpr double largest_step_of_log = 1.5;
/**
 * The distance of the two bounds of a share that is enough, over its distance
 * from one, for a step of log f of one: Newton's next error is about the square
 * of that. It is at least that part of it.
 */
constexpr double good_width = 0.1, least_part_of_width = 1e-2;
/** The error of a point to go on from, over the change of log f, and at least.
 */
constexpr double error_of_change = 10., least_error_of_start = 1e-4;
/** The width that is tried first, and that of most digits. */
constexpr double first_tolerance = 1e-3, tolerance_of_share = 1e-10;
constexpr unsigned int n_max_of_share = 60;
/** What is rounding of a divisor, and of forces beyond their limits. */
constexpr double rounding_of_divisor = 1e-14, rounding_of_excess = 1e-13;
/** How far the least divisor of a mechanism is looked for, and how closely over
 * the tolerance. */
constexpr double most_below = 4., closeness = 0.01;

/** The work of friction of forces @p x of rows in a motion. */
double work_of_friction(const RowProblem &by_rows,
                        const std::vector<double> &x,
                        const std::vector<double> &u)
{
  const DiscreteProblem &problem = by_rows.of();
  const std::vector<double> forces = by_rows.rows().forces_of(x);
  double work = 0.;
  if (!problem.is_plane())
  {
    const std::vector<double> jumps = by_rows.rows().jumps(u);
    for (unsigned int e = 0; e < problem.joints().size(); ++e)
      problem.for_each_set(e, [&](const unsigned int size,
                                  const unsigned int row, unsigned int) {
        const std::size_t first = problem.first_row(e) + row;
        // Behind the pressure, if there is one.
        for (std::size_t k = first + size % 2; k < first + size; ++k)
          work += forces[k] * jumps[k];
      });
    return work;
  }
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    work += std::abs(forces[problem.first_row(e) + problem.n_contacts(e)] *
                     problem.sliding(e, u.data()));
  return work;
}
} // namespace

bool has_coefficient(const Scene &scene)
{
  return !scene.coefficient.empty();
}

bool has_coefficient(const SpaceScene &scene)
{
  return !scene.blocks->strengths.coefficient.empty();
}

template <typename SceneOf>
DividedStrengths<SceneOf>::Divided::Divided(const SceneOf &of,
                                            const double divisor)
    : divisor(divisor), scene(with_strengths_divided(of, divisor)),
      problem(discretise(scene)), blend(problem)
{}

template <typename SceneOf>
double DividedStrengths<SceneOf>::Divided::carried() const
{
  return factor->carried() ? factor->carried()->alpha : 0.;
}

/** The share and its slope. */
template <typename SceneOf>
ShareOfLoads DividedStrengths<SceneOf>::Divided::share()
{
  ShareOfLoads share;
  if (!factor->carried() || !factor->mechanism() || !(factor->bound() > 0.))
    return share;
  const std::vector<double> &u = factor->mechanism()->u;
  share.t = factor->bound();
  share.slope = work_of_friction(blend.by_rows(), factor->carried()->x, u) /
                dot(blend.program().live, u);
  return share;
}

template <typename SceneOf>
DividedStrengths<SceneOf>::DividedStrengths(const SceneOf &scene,
                                            const LoadFactorControls &controls,
                                            Terminal &terminal)
    : scene(scene), controls(controls), terminal(terminal)
{
  found.carried = 0.;
  found.bound = std::numeric_limits<double>::infinity();
}

/** Whether both bounds of a share answer a question. */
template <typename SceneOf>
bool DividedStrengths<SceneOf>::is_enough(Divided &divided,
                                          const Question question) const
{
  const double carried = divided.carried(), bound = divided.factor->bound(),
               distance = carried >= 1. ? carried - 1. : 1. - bound;
  if (!(distance > 0.) || question == Question::side)
    return distance > 0.;
  const double step = std::abs(
      std::log(newton(divided.divisor, divided.share()) / divided.divisor));
  return bound - carried <=
         good_width * distance * std::clamp(step, least_part_of_width, 1.);
}

/** Whether the programme answers a question within a tolerance of its width. */
template <typename SceneOf>
bool DividedStrengths<SceneOf>::find(Divided &divided,
                                     const Question question,
                                     const double tolerance)
{
  std::optional<ProvenFactor> &factor = divided.factor;
  factor.emplace(
      divided.blend.by_rows().forces(), divided.blend.program(),
      ProvenFactor::Controls{
          tolerance, 1., std::min(n_max_of_share, controls.n_max_iterations)},
      terminal);
  factor->follow(course);
  factor->find([&] { return is_enough(divided, question); });
  found.n_iterations += factor->n_iterations();
  return is_enough(divided, question) ||
         factor->state() == SelfDual::State::unbounded;
}

template <typename SceneOf>
ShareOfLoads DividedStrengths<SceneOf>::judge(const double divisor,
                                              const Question question)
{
  Divided divided(scene, divisor);
  course.cut(std::max(least_error_of_start,
                      error_of_change *
                          std::abs(std::log(divisor / divisor_of_course))));
  const bool is_warm = !course.stops.empty();
  divisor_of_course = divisor;
  // The farther from one the share is, the earlier its side is known.
  if (!find(divided, question, first_tolerance) &&
      !find(divided, question, tolerance_of_share) && is_warm)
  {
    // Once more from the usual start.
    course.stops.clear();
    find(divided, question, tolerance_of_share);
  }
  const ProvenFactor &factor = *divided.factor;
  ShareOfLoads share = divided.share();
  if (divided.carried() >= 1.)
  {
    share.is_carried = true;
    keep_forces(divided, divided.blend.forces_of_all(factor.carried()->x,
                                                     divided.carried()));
  }
  else if (factor.mechanism() && factor.bound() < 1.)
    share.collapses = keep_mechanism(divided);
  if (!share.is_carried && !share.collapses)
  {
    // Where any share is carried none has been found.
    RowProblem &by_rows = divided.blend.by_rows();
    const FeasibleForces any = find_feasible_forces(
        by_rows, by_rows.loads(), controls.n_max_iterations, terminal);
    found.n_iterations += any.n_iterations;
    share.is_carried = any.state.has_value();
    if (any.state)
      keep_forces(divided, by_rows.rows().forces_of(any.state->x));
  }
  terminal.iteration("Strength factor",
                     text("divided by ", divisor, ": share ", divided.carried(),
                          " to ", factor.bound(), "; ", found.carried,
                          " is carried, ", found.bound, " collapses"));
  return share;
}

/** Keep forces that carry the loads. */
template <typename SceneOf>
void DividedStrengths<SceneOf>::keep_forces(const Divided &divided,
                                            std::vector<double> forces)
{
  Solution state;
  state.stop = Stop::Reason::converged;
  state.forces = std::move(forces);
  typename SceneOf::Forces of_blocks =
      dimensional_forces(divided.problem, scene, state);
  const double greatest = greatest_divisor(divided, of_blocks);
  if (greatest <= found.carried)
    return;
  found.forces = std::move(of_blocks);
  found.carried = greatest;
}

/**
 * The greatest divisor with which forces are as much within their limits; not
 * one that is greater within the tolerance, whose digits are those of chance.
 * In space it is that of the resultants of faces, if it is one of all points.
 */
template <typename SceneOf>
double DividedStrengths<SceneOf>::greatest_divisor(
    const Divided &divided, const typename SceneOf::Forces &forces) const
{
  if (!std::isfinite(divided.divisor))
    return divided.divisor;
  const Certificate proof = certify(divided.scene, forces);
  const double larger =
      divided.divisor / proof.max_utilisation * (1. - rounding_of_divisor);
  if (!(larger > divided.divisor * (1. + controls.tolerance) &&
        std::isfinite(larger)))
    return divided.divisor;
  const Certificate other =
      certify(with_strengths_divided(scene, larger), forces);
  return other.unbalanced.size() <= proof.unbalanced.size() &&
                 other.admissibility_violation <=
                     std::max(proof.admissibility_violation, rounding_of_excess)
             ? larger
             : divided.divisor;
}

/** Whether the mechanism is a proof, kept if it is a better one. */
template <typename SceneOf>
bool DividedStrengths<SceneOf>::keep_mechanism(Divided &divided)
{
  const RowProblem &by_rows = divided.blend.by_rows();
  typename SceneOf::MotionOfBlocks motion = dimensional_motion(
      divided.problem, divided.scene,
      by_rows.of_size_one(divided.factor->mechanism()->u), 1.);
  const MechanismCertificate proof = certify_mechanism(divided.scene, motion);
  if (!proves_collapse(proof))
    return false;
  const double least = least_divisor(divided.divisor, motion);
  if (least < found.bound)
  {
    found.mechanism = std::move(motion);
    found.bound = least;
    found.proof = {
        least, 0.,
        certify_mechanism(with_strengths_divided(scene, least), found.mechanism)
            .closing_violation};
  }
  return true;
}

/** The least divisor, from a quarter of it on, with which a proof of collapse
 * still is one. */
template <typename SceneOf>
double DividedStrengths<SceneOf>::least_divisor(
    const double divisor, const typename SceneOf::MotionOfBlocks &motion) const
{
  const auto is_proof = [&](const double other) {
    return proves_collapse(
        certify_mechanism(with_strengths_divided(scene, other), motion));
  };
  // Most are none with less.
  if (!std::isfinite(divisor) || !is_proof(divisor * (1. - controls.tolerance)))
    return divisor;
  double least = divisor,
         too_small = std::max(found.carried, divisor / most_below);
  while (least - too_small > closeness * controls.tolerance * least)
  {
    const double middle = std::sqrt(least * too_small);
    (is_proof(middle) ? least : too_small) = middle;
  }
  return least;
}

/*
 * With one mechanism t is linear in one over the divisor, and of Tresca's
 * friction the least of such; of Coulomb's, in whose mechanisms joints open the
 * less the greater the divisor is, one over t is nearly linear in its
 * logarithm.
 */
template <typename SceneOf>
double DividedStrengths<SceneOf>::newton(const double divisor,
                                         const ShareOfLoads &share) const
{
  if (!(share.slope > 0.))
    return share.is_carried ? without_strengths : 0.;
  if (has_coefficient(scene))
    return divisor *
           std::exp(std::clamp((share.t - 1.) * share.t / share.slope,
                               -largest_step_of_log, largest_step_of_log));
  const double part = 1. + (1. - share.t) / share.slope;
  return part > 0. ? divisor / part : without_strengths;
}

template class DividedStrengths<Scene>;
template class DividedStrengths<SpaceScene>;
} // namespace Voussoir
