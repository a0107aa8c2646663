// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/analyses/factors/strength_factor.h>
#include <voussoir/base/text.h>
#include <voussoir/scene/proofs/space_certificate.h>
#include <voussoir/statics/conic/blended_loads.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/problem/discretise.h>
#include <voussoir/statics/problem/discretise_space.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace Voussoir
{
namespace
{
/** Strengths that much smaller, or greater, are none, or any. */
constexpr double largest_divisor = 1e6;
/** The step of a divisor where nothing says how long it is to be. */
constexpr double usual_step = 4.;
/** The largest step of log f. */
constexpr double largest_step_of_log = 3.;
constexpr double infinite = std::numeric_limits<double>::infinity();
/** A step of Newton's, over the divisor, behind which its error is rounding. */
constexpr double short_step = 1e-4;
constexpr unsigned int n_max_of_newton = 40;
/** Where an interval is cut, in turn. */
constexpr std::array<double, 5> places = {{0.5, 0.25, 0.75, 0.05, 0.95}};
/** The distance of a proof from the limit, over the tolerance, and its growth.
 */
constexpr double first_distance = 0.4, growth_of_distance = 4.;
/** Where the limit is not nearer than that, it is not known. */
constexpr double largest_distance = 1e-2;
/** The distance of the two bounds of a share that is enough, over its distance
 * from one, and where that is nothing. */
constexpr double good_width = 1e-2, small_distance_from_one = 1e-6;
/** The error of a point to go on from, over the change of log f, and at least.
 */
constexpr double error_of_change = 10., least_error_of_start = 1e-4;
constexpr double tolerance_of_share = 1e-10;
constexpr unsigned int n_max_of_share = 100;

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

/** @{ */
/** Whether strengths grow with the pressure. */
bool has_coefficient(const Scene &scene)
{
  return !scene.coefficient.empty();
}
bool has_coefficient(const SpaceScene &scene)
{
  return !scene.blocks->strengths.coefficient.empty();
}
/** @} */
/**
 * The search. At a divisor f the greatest share t of loads that are blended,
 * BlendedLoads, says whether they are carried or collapse. Its derivative with
 * -log f is the work of friction in the mechanism in which the live loads do
 * the work one, with which Newton's method finds where it is one.
 */
template <typename SceneOf>
class StrengthSearch
{
public:
  StrengthSearch(const SceneOf &scene,
                 const LoadFactorControls &controls,
                 Terminal &terminal)
      : scene(scene), controls(controls), terminal(terminal)
  {}

  FactorAnswerOf<SceneOf> find();

private:
  /** What is known of one divisor. */
  struct Share
  {
    bool is_carried = false, collapses = false;
    /** t, and its derivative with -log f; zero if not known. */
    double t = 0., slope = 0.;
  };
  Share judge(double divisor);
  void keep_forces(double divisor,
                   const DiscreteProblem &problem,
                   std::vector<double> forces);
  bool keep_mechanism(double divisor,
                      const SceneOf &divided,
                      const RowProblem &by_rows,
                      const ProvenFactor &factor);
  double newton(double divisor, const Share &share) const;
  double next(double divisor, const Share &share);
  double find_limit();
  void find_proofs(double limit);
  void bisect();

  const SceneOf &scene;
  const LoadFactorControls &controls;
  Terminal &terminal;
  FactorOf<SceneOf> found;
  /** The way to the share of a divisor, which others begin with. */
  ProvenFactor::Course course;
  double divisor_of_course = 1.;
  /** Of the last two steps of Newton's, of log f. */
  std::array<double, 2> lengths = {{infinite, infinite}};
  /** Whether no strengths at all were looked at. */
  bool has_seen_none = false;
};

/** Look at one divisor, and keep proofs that are better. */
template <typename SceneOf>
typename StrengthSearch<SceneOf>::Share
StrengthSearch<SceneOf>::judge(const double divisor)
{
  const SceneOf divided = with_strengths_divided(scene, divisor);
  const DiscreteProblem problem = discretise(divided);
  BlendedLoads blend(problem);
  RowProblem &by_rows = blend.by_rows();
  ProvenFactor factor(by_rows.forces(), blend.program(),
                      {tolerance_of_share, 1.,
                       std::min(n_max_of_share, controls.n_max_iterations)},
                      terminal);
  const auto carried = [&] {
    return factor.carried() ? factor.carried()->alpha : 0.;
  };
  const auto is_enough = [&] {
    const double distance =
        carried() >= 1. ? carried() - 1. : 1. - factor.bound();
    return distance > 0. &&
           factor.bound() - carried() <=
               good_width * std::max(distance, small_distance_from_one);
  };
  course.cut(std::max(least_error_of_start,
                      error_of_change *
                          std::abs(std::log(divisor / divisor_of_course))));
  const bool is_warm = !course.stops.empty();
  divisor_of_course = divisor;
  factor.follow(course);
  factor.find(is_enough);
  if (is_warm && factor.state() != SelfDual::State::unbounded && !is_enough())
  {
    // Once more from the usual start.
    course.stops.clear();
    factor.find(is_enough);
  }
  found.n_iterations += factor.n_iterations();
  Share share;
  if (carried() >= 1.)
  {
    share.is_carried = true;
    keep_forces(divisor, problem,
                blend.forces_of_all(factor.carried()->x, carried()));
  }
  else if (factor.mechanism() && factor.bound() < 1.)
    share.collapses = keep_mechanism(divisor, divided, by_rows, factor);
  if (factor.carried() && factor.mechanism() && factor.bound() > 0.)
  {
    const std::vector<double> &u = factor.mechanism()->u;
    share.t = factor.bound();
    share.slope = work_of_friction(by_rows, factor.carried()->x, u) /
                  dot(blend.program().live, u);
  }
  if (!share.is_carried && !share.collapses)
  {
    // Where any share is carried none has been found.
    const FeasibleForces any = find_feasible_forces(
        by_rows, by_rows.loads(), controls.n_max_iterations, terminal);
    found.n_iterations += any.n_iterations;
    share.is_carried = any.state.has_value();
    if (any.state)
      keep_forces(divisor, problem, by_rows.rows().forces_of(any.state->x));
  }
  terminal.iteration("Strength factor",
                     text("divided by ", divisor, ": share ", carried(), " to ",
                          factor.bound()));
  return share;
}

/** Keep forces that carry the loads. */
template <typename SceneOf>
void StrengthSearch<SceneOf>::keep_forces(const double divisor,
                                          const DiscreteProblem &problem,
                                          std::vector<double> forces)
{
  if (divisor <= found.carried)
    return;
  Solution state;
  state.stop = Stop::Reason::converged;
  state.forces = std::move(forces);
  found.forces = dimensional_forces(problem, scene, state);
  found.carried = divisor;
}

/** Whether the mechanism is a proof, kept if it is a better one. */
template <typename SceneOf>
bool StrengthSearch<SceneOf>::keep_mechanism(const double divisor,
                                             const SceneOf &divided,
                                             const RowProblem &by_rows,
                                             const ProvenFactor &factor)
{
  typename SceneOf::MotionOfBlocks motion = dimensional_motion(
      by_rows.of(), divided, by_rows.of_size_one(factor.mechanism()->u), 1.);
  const MechanismCertificate proof = certify_mechanism(divided, motion);
  if (!proves_collapse(proof))
    return false;
  if (divisor < found.bound)
  {
    found.mechanism = std::move(motion);
    found.bound = divisor;
    found.proof = {divisor, 0., proof.closing_violation};
  }
  return true;
}

/**
 * Where by Newton's method t is one. With one mechanism t is linear in one over
 * the divisor, and of Tresca's friction the least of such; of Coulomb's, in
 * whose mechanisms joints open the less the greater the divisor is, one over t
 * is nearly linear in its logarithm. Zero if nothing is known; infinite if no
 * strengths are needed.
 */
template <typename SceneOf>
double StrengthSearch<SceneOf>::newton(const double divisor,
                                       const Share &share) const
{
  if (!(share.slope > 0.))
    return share.is_carried ? infinite : 0.;
  if (has_coefficient(scene))
    return divisor *
           std::exp(std::clamp((share.t - 1.) * share.t / share.slope,
                               -largest_step_of_log, largest_step_of_log));
  const double part = 1. + (1. - share.t) / share.slope;
  return part > 0. ? divisor / part : infinite;
}

/** The divisor to look at behind one that was looked at. */
template <typename SceneOf>
double StrengthSearch<SceneOf>::next(const double divisor, const Share &share)
{
  const double wanted = newton(divisor, share);
  const double length = std::abs(std::log(wanted / divisor));
  // Where t jumps Newton's method goes to and fro.
  const bool has_both = found.carried > 0. && std::isfinite(found.bound);
  const bool is_slow = has_both && !(length < 0.5 * lengths[1]);
  lengths = {{length, lengths[0]}};
  if (!is_slow && wanted > found.carried && wanted <= found.bound &&
      (std::isfinite(wanted) || !has_seen_none))
    return wanted;
  if (has_both)
    return std::sqrt(found.carried * found.bound);
  return share.is_carried ? divisor * usual_step : divisor / usual_step;
}

/** Where the share is one; infinite if no strengths are needed. */
template <typename SceneOf>
double StrengthSearch<SceneOf>::find_limit()
{
  double divisor = 1.;
  for (unsigned int n = 0; n < n_max_of_newton; ++n)
  {
    const double last = divisor;
    divisor = next(last, judge(last));
    if (divisor > largest_divisor && !has_seen_none)
    {
      has_seen_none = true;
      if (judge(infinite).is_carried)
        return infinite;
    }
    if (std::isinf(divisor))
      divisor = last * usual_step;
    divisor = std::clamp(divisor, 1. / largest_divisor, largest_divisor);
    // The next error of Newton's method is rounding; or both proofs are there.
    if (lengths[0] < short_step ||
        found.bound - found.carried <= controls.tolerance * found.carried ||
        divisor == last)
      return divisor;
  }
  return divisor;
}

/** Prove what is carried and what collapses, on both sides. */
template <typename SceneOf>
void StrengthSearch<SceneOf>::find_proofs(const double limit)
{
  const double first = first_distance * controls.tolerance;
  for (const double side : {-1., 1.})
    for (double distance = first; distance < largest_distance;
         distance *= growth_of_distance)
    {
      const double divisor = limit * (1. + side * distance);
      if (side < 0. ? found.carried >= divisor : found.bound <= divisor)
        break;
      if (const Share share = judge(divisor);
          side < 0. ? share.is_carried : share.collapses)
        break;
    }
}

/**
 * Close in on a limit that Newton's method has missed; where a divisor is left
 * undecided others are looked at.
 */
template <typename SceneOf>
void StrengthSearch<SceneOf>::bisect()
{
  unsigned int n_undecided = 0;
  for (unsigned int n = 0; n < n_max_of_newton && n_undecided < places.size() &&
                           found.carried > 0. && std::isfinite(found.bound) &&
                           found.width() > controls.tolerance;
       ++n)
  {
    const Share share =
        judge(found.carried *
              std::pow(found.bound / found.carried, places[n_undecided]));
    n_undecided = share.is_carried || share.collapses ? 0 : n_undecided + 1;
  }
}

template <typename SceneOf>
FactorAnswerOf<SceneOf> StrengthSearch<SceneOf>::find()
{
  found.carried = 0.;
  found.bound = infinite;
  FactorAnswerOf<SceneOf> answer;
  const double limit = find_limit();
  if (std::isinf(limit))
  {
    // Pressure alone carries the loads, with any strengths.
    found.is_unbounded = true;
    found.carried = 1.;
    found.stop = Stop::Reason::converged;
    answer.factor = std::move(found);
    return answer;
  }
  if (limit * largest_divisor > 1. && limit < largest_divisor)
    find_proofs(limit);
  bisect();
  if (!(found.carried > 0.) && found.has_mechanism())
  {
    answer.collapse = std::move(found.mechanism);
    return answer;
  }
  if (!(found.carried > 0.))
    throw SolverError("The strength factor was not found: neither forces nor a "
                      "mechanism prove anything, whatever the strengths. Try a "
                      "larger 'Solver/Maximum iterations'.");
  found.stop = found.width() <= controls.tolerance ? Stop::Reason::converged
                                                   : Stop::Reason::rounding;
  answer.factor = std::move(found);
  return answer;
}
} // namespace

template <typename SceneOf>
FactorAnswerOf<SceneOf> find_strength_factor(const SceneOf &scene,
                                             const LoadFactorControls &controls,
                                             Terminal &terminal)
{
  return StrengthSearch<SceneOf>(scene, controls, terminal).find();
}

template FactorAnswerOf<Scene>
find_strength_factor(const Scene &, const LoadFactorControls &, Terminal &);
template FactorAnswerOf<SpaceScene> find_strength_factor(
    const SpaceScene &, const LoadFactorControls &, Terminal &);
} // namespace Voussoir
