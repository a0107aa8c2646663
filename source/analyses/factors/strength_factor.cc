// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/factors/divided_strengths.h>
#include <voussoir/analyses/factors/strength_factor.h>
#include <voussoir/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
/** Strengths that much smaller, or greater, are none, or any. */
constexpr double largest_divisor = 1e6;
/** The step of a divisor where nothing says how long it is to be. */
constexpr double usual_step = 4.;
constexpr double infinite = std::numeric_limits<double>::infinity();
/** A step of Newton's, over the divisor, behind which its error is rounding. */
constexpr double short_step = 1e-4;
constexpr unsigned int n_max_of_newton = 40;
/** What is left of an interval behind a good cut; half of it if it is halved.
 */
constexpr double good_cut = 0.6;
/** How far a share is from one that is so by rounding. */
constexpr double rounding_of_share = 1e-8;
/** How many slow steps show that the share jumps. */
constexpr unsigned int n_slow_of_jump = 3;
/** How many divisors without an answer end a search for a collapse. */
constexpr unsigned int n_undecided_of_one_side = 3;
/** Where an interval is cut, in turn. */
constexpr std::array<double, 3> places = {{0.5, 0.25, 0.75}};
/** The distance of a proof from the limit, over the tolerance, and its growth.
 */
constexpr double first_distance = 0.4, growth_of_distance = 4.;
/** Where the limit is not nearer than that, it is not known. */
constexpr double largest_distance = 1e-2;

/**
 * The search for the divisor whose share is one, by Newton's method. Where
 * blocks begin to wedge the share jumps; it may become infinite, as where a
 * stress of the blocks alone carries any loads. There intervals are cut.
 */
template <typename SceneOf>
class StrengthSearch
{
public:
  StrengthSearch(const SceneOf &scene,
                 const LoadFactorControls &controls,
                 Terminal &terminal)
      : scene(scene), controls(controls), strengths(scene, controls, terminal)
  {}

  FactorAnswerOf<SceneOf> find();

private:
  using Question = typename DividedStrengths<SceneOf>::Question;
  /** A divisor that was looked at. */
  struct End
  {
    double divisor;
    ShareOfLoads share;
  };
  bool has_both() const
  {
    return found.carried > 0. && std::isfinite(found.bound);
  }
  double between();
  double secant() const;
  double next(double divisor, const ShareOfLoads &share);
  void leave_undecided(double divisor);
  double find_limit();
  void find_proofs(double limit);
  void bisect();

  const SceneOf &scene;
  const LoadFactorControls &controls;
  DividedStrengths<SceneOf> strengths;
  /** What `strengths` has found. */
  const FactorOf<SceneOf> &found = strengths.best();
  /** Of the last two steps of Newton's, of log f. */
  std::array<double, 2> lengths = {{infinite, infinite}};
  /** @{ */
  /** The greatest that is carried and the least that collapses. */
  End carried_end = {0., {}}, collapsing_end = {infinite, {}};
  /** @} */
  /** Their distance, of log f, when it was cut last. */
  double length_before = infinite;
  /** How often that was not halved. */
  unsigned int n_slow = 0;
  /** The next step from where any share is carried; the square of the last. */
  double next_step = usual_step;
  /** @{ */
  /** The least divisor without an answer, and how many there were. */
  double undecided = infinite;
  unsigned int n_undecided = 0;
  /** @} */
  /** Whether the share jumps, so that its sides count, and not by how much. */
  bool is_cutting = false;
  /** Whether no strengths at all were looked at. */
  bool has_seen_none = false;
};

/**
 * Between what is carried and what collapses, where the shares of both say that
 * it is one, or in the middle.
 */
template <typename SceneOf>
double StrengthSearch<SceneOf>::between()
{
  const double length = std::log(found.bound / found.carried);
  const bool is_slow = !(length < good_cut * length_before);
  length_before = length;
  if (is_slow && ++n_slow == n_slow_of_jump)
    is_cutting = true;
  if (!is_slow && !is_cutting && carried_end.share.t > 0. &&
      collapsing_end.share.t > 0.)
  {
    const double wanted = secant();
    if (wanted > found.carried && wanted < found.bound)
      return wanted;
  }
  return std::sqrt(found.carried * found.bound);
}

/** Where a line through both ends is one: of t over one over the divisor, or of
 * one over t over its logarithm, as in DividedStrengths::newton(). */
template <typename SceneOf>
double StrengthSearch<SceneOf>::secant() const
{
  const bool is_of_log = has_coefficient(scene);
  const auto place = [&](const End &end) {
    return is_of_log ? std::log(end.divisor) : 1. / end.divisor;
  };
  const auto value = [&](const End &end) {
    return is_of_log ? 1. / end.share.t - 1. : end.share.t - 1.;
  };
  const double a = place(carried_end), b = place(collapsing_end),
               at_a = value(carried_end), at_b = value(collapsing_end),
               root = a + (b - a) * at_a / (at_a - at_b);
  return is_of_log ? std::exp(root) : 1. / root;
}

/** The divisor to look at behind one that was looked at. */
template <typename SceneOf>
double StrengthSearch<SceneOf>::next(const double divisor,
                                     const ShareOfLoads &share)
{
  const double wanted = strengths.newton(divisor, share);
  const double length = std::abs(std::log(wanted / divisor));
  if (share.is_carried && divisor >= carried_end.divisor)
    carried_end = {divisor, share};
  if (share.collapses && divisor <= collapsing_end.divisor)
    collapsing_end = {divisor, share};
  // Where t jumps Newton's method goes to and fro.
  const bool is_slow = has_both() && !(length < 0.5 * lengths[1]);
  lengths = {{length, lengths[0]}};
  if (!is_cutting && !is_slow && wanted > found.carried &&
      wanted <= found.bound && (std::isfinite(wanted) || !has_seen_none))
    return wanted;
  if (has_both())
    return between();
  if (found.carried > 0. && undecided > found.carried &&
      std::isfinite(undecided))
    return std::sqrt(found.carried * undecided);
  if (!share.is_carried)
    return divisor / usual_step;
  const double step = std::isinf(wanted) ? next_step : usual_step;
  next_step *= step;
  return divisor * step;
}

/** Where there is no answer the share jumps, or some divisors later. */
template <typename SceneOf>
void StrengthSearch<SceneOf>::leave_undecided(const double divisor)
{
  undecided = std::min(undecided, divisor);
  ++n_undecided;
  is_cutting = has_both() ||
               (found.carried > 0. && n_undecided >= n_undecided_of_one_side);
}

/** Where the share is one; infinite if no strengths are needed. */
template <typename SceneOf>
double StrengthSearch<SceneOf>::find_limit()
{
  double divisor = 1.;
  for (unsigned int n = 0; n < n_max_of_newton; ++n)
  {
    const double last = divisor;
    const ShareOfLoads share =
        strengths.judge(last, is_cutting ? Question::side : Question::share);
    if (!share.is_carried && !share.collapses)
    {
      // At the limit itself there is no side.
      if (share.t > 0. && std::abs(share.t - 1.) < rounding_of_share)
        return last;
      leave_undecided(last);
      if (is_cutting)
        return last;
    }
    divisor = next(last, share);
    if (divisor > largest_divisor && !has_seen_none)
    {
      has_seen_none = true;
      if (strengths.judge(infinite, Question::side).is_carried)
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
      if (const ShareOfLoads share = strengths.judge(divisor, Question::side);
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
  unsigned int n_missed = 0;
  for (unsigned int n = 0; n < n_max_of_newton && n_missed < places.size() &&
                           has_both() && found.width() > controls.tolerance;
       ++n)
  {
    const ShareOfLoads share = strengths.judge(
        found.carried * std::pow(found.bound / found.carried, places[n_missed]),
        Question::side);
    n_missed = share.is_carried || share.collapses ? 0 : n_missed + 1;
  }
}

template <typename SceneOf>
FactorAnswerOf<SceneOf> StrengthSearch<SceneOf>::find()
{
  const double limit = find_limit();
  const bool needs_none = std::isinf(limit);
  if (!needs_none)
  {
    if (!is_cutting && limit * largest_divisor > 1. && limit < largest_divisor)
      find_proofs(limit);
    bisect();
  }
  FactorOf<SceneOf> factor = strengths.take();
  FactorAnswerOf<SceneOf> answer;
  if (needs_none)
  {
    // Pressure alone carries the loads, with any strengths.
    factor.is_unbounded = true;
    factor.carried = 1.;
    factor.stop = Stop::Reason::converged;
    answer.factor = std::move(factor);
    return answer;
  }
  if (!(factor.carried > 0.) && factor.has_mechanism())
  {
    answer.collapse = std::move(factor.mechanism);
    return answer;
  }
  if (!(factor.carried > 0.))
    throw SolverError("The strength factor was not found: neither forces nor a "
                      "mechanism prove anything, whatever the strengths. Try a "
                      "larger 'Solver/Maximum iterations'.");
  const bool is_wide = !(factor.width() <= controls.tolerance);
  factor.is_at_jump = is_wide && (is_cutting || !std::isfinite(factor.bound));
  factor.stop = is_wide ? Stop::Reason::rounding : Stop::Reason::converged;
  answer.factor = std::move(factor);
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
