// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/capacity/capacity_curve.h>
#include <voussoir/analyses/capacity/capacity_path.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/scene/proofs/certificate.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
/** A jump of a motion, over its largest displacement, that is none. */
constexpr double least_jump_of_motion = 1e-7;
/** The largest turn of a cell in a step; radians. */
constexpr double largest_turn = 0.1;
/** A factor, over that at rest, that is next to none; rounds to find it. */
constexpr double error_of_ultimate = 1e-9;
constexpr unsigned int n_rounds_of_ultimate = 12;
/** The most joints that a hinge goes over to in a step. */
constexpr unsigned int n_switches = 10;
/** The most steps, over the points that are wanted. */
constexpr unsigned int most_steps = 8;

/** One search; an object is used once. */
class CapacitySearch
{
public:
  CapacitySearch(const Scene &dead,
                 const Scene &live,
                 const CapacityWanted &wanted,
                 const LoadFactorControls &controls,
                 Terminal &terminal)
      : dead(dead), live(live), wanted(wanted), controls(controls),
        terminal(terminal), path(make_capacity_path(dead, wanted))
  {}

  CapacityAnswer find();

private:
  /** What a step came to. */
  struct Gone
  {
    bool has_factor; /**< there */
    std::string end; /**< why the curve ends there; empty if it goes on */
  };

  LoadFactorAnswer factor_at(const Placement &place) const
  {
    return find_load_factor(place.moved(dead), place.moved(live), controls,
                            Terminal::silent());
  }
  std::string take(CapacityStop &stop, const LoadFactor &factor) const;
  Gone go(const CapacityStop &from, double step, CapacityStop &to) const;
  void find_ultimate(const CapacityStop &before,
                     double step,
                     CapacityCurve &curve) const;
  void find_last_place(const CapacityStop &before,
                       double step,
                       CapacityCurve &curve) const;
  void follow(CapacityStop stop, CapacityCurve &curve) const;
  double participation(const Motion &mechanism) const;

  const Scene &dead, &live;
  const CapacityWanted &wanted;
  const LoadFactorControls &controls;
  Terminal &terminal;
  const std::unique_ptr<const CapacityPath> path;
};

/**
 * Take the factor at a position, and which ends of joints the motion from there
 * opens.
 *
 * @return why the curve cannot go on; empty if it can.
 */
std::string CapacitySearch::take(CapacityStop &stop,
                                 const LoadFactor &factor) const
{
  const dealii::Point<2> place =
      stop.place.positions().of(dead.packing, wanted.cell, wanted.place);
  stop.point.displacement = (place - wanted.place) * wanted.direction;
  stop.point.carried = factor.carried;
  stop.point.bound = factor.bound;
  stop.point.error_of_state =
      certify(stop.place.moved(dead, &live, factor.carried), factor.forces)
          .error();
  std::string end = path->take(stop, factor);
  if (!end.empty())
    return end;
  if (const auto e = stop.place.open_ends_of(
          stop.jumps, least_jump_of_motion * stop.jumps.largest_displacement))
    end = text("blocks slide, at ",
               text_of_point(stop.place.packing().interfaces()[*e].midpoint()));
  return end;
}

/** A step that turns no cell too much. */
double without_large_turns(const Motion &motion, const double step)
{
  double fastest = 0.;
  for (const double angle : motion.rotation)
    fastest = std::max(fastest, std::abs(angle));
  return fastest > 0. ? std::min(step, largest_turn / fastest) : step;
}

/**
 * Go on along the motion.
 *
 * @param to takes the next position.
 */
CapacitySearch::Gone CapacitySearch::go(const CapacityStop &from,
                                        const double step,
                                        CapacityStop &to) const
{
  to.place = from.place;
  to.place.advance(from.motion, step);
  try
  {
    LoadFactorAnswer answer = factor_at(to.place);
    for (unsigned int k = 0; k < n_switches && path->falls(answer) &&
                             to.place.switch_hinges(answer.collapse);
         ++k)
      answer = factor_at(to.place);
    if (path->falls(answer))
      return {false, path->words_of_fall()};
    return {true, take(to, *answer.factor)};
  }
  catch (const SolverError &)
  {
    return {false, "no factor is found any more"};
  }
  catch (const InputError &)
  {
    return {false, "the blocks cannot follow the supports"};
  }
}

/**
 * Where the factor is next to zero, behind a position where it is not yet, and
 * before one where it is less: something is still carried there.
 */
void CapacitySearch::find_ultimate(const CapacityStop &before,
                                   const double step,
                                   CapacityCurve &curve) const
{
  const double most = error_of_ultimate * curve.points.front().carried;
  const auto above = [&](const double factor) { return factor - 0.5 * most; };
  double low = 0., above_low = above(before.point.carried);
  double high = step, above_high = above(curve.points.back().carried);
  for (unsigned int round = 0; round < n_rounds_of_ultimate; ++round)
  {
    const double at = low + (high - low) * above_low / (above_low - above_high);
    CapacityStop stop = before;
    if (!go(before, at, stop).has_factor)
      break; // what was found before stands
    curve.points.back() = stop.point;
    const double factor = stop.point.carried;
    if (factor > 0. && factor <= most)
      break;
    (above(factor) > 0. ? low : high) = at;
    (above(factor) > 0. ? above_low : above_high) = above(factor);
  }
  curve.ultimate = curve.points.back().displacement;
}

/**
 * The last place where blocks stay, behind a position where they do, and
 * before one where they do not, by bisection.
 */
void CapacitySearch::find_last_place(const CapacityStop &before,
                                     const double step,
                                     CapacityCurve &curve) const
{
  CapacityPoint last = before.point;
  double low = 0., high = step;
  while (high - low > path->error_of_last_place())
  {
    const double at = 0.5 * (low + high);
    CapacityStop stop = before;
    const bool has_factor = go(before, at, stop).has_factor;
    if (has_factor)
      last = stop.point;
    (has_factor ? low : high) = at;
  }
  if (low > 0.)
    curve.points.push_back(last);
  curve.ultimate = last.displacement;
}

double CapacitySearch::participation(const Motion &mechanism) const
{
  double P = 0., Pd = 0., Pdd = 0.;
  for (unsigned int c = 0; c < dead.load.size(); ++c)
  {
    const double weight = dead.load[c].norm();
    const double d = mechanism.displacement[c] * wanted.direction;
    P += weight;
    Pd += weight * d;
    Pdd += weight * d * d;
  }
  return P * Pdd > 0. ? Pd * Pd / (P * Pdd)
                      : std::numeric_limits<double>::quiet_NaN();
}

void CapacitySearch::follow(CapacityStop stop, CapacityCurve &curve) const
{
  double step = path->first_step();
  for (unsigned int k = 0; k < most_steps * wanted.n_points; ++k)
  {
    CapacityStop next = stop;
    step = without_large_turns(stop.motion, step);
    const Gone gone = go(stop, step, next);
    curve.end = gone.end;
    if (!gone.has_factor)
    {
      if (path->error_of_last_place() > 0.)
        find_last_place(stop, step, curve);
      return;
    }
    curve.points.push_back(next.point);
    terminal.iteration("Capacity",
                       text("displacement ", next.point.displacement,
                            ", factor ", next.point.carried));
    if (next.point.carried <= 0.)
    {
      find_ultimate(stop, step, curve);
      curve.end = "the factor is zero";
      return;
    }
    if (curve.end.empty())
      curve.end = path->end_at(next);
    if (!curve.end.empty())
      return;
    step = path->next_step(curve.points, next);
    stop = std::move(next);
  }
  curve.end = "there are many steps";
}

CapacityAnswer CapacitySearch::find()
{
  CapacityAnswer answer;
  CapacityCurve &curve = answer.curve;
  curve.has_moving_supports = !wanted.of_supports.empty();
  curve.ultimate = curve.participation =
      std::numeric_limits<double>::quiet_NaN();
  answer.at_rest = find_load_factor(dead, live, controls, terminal);
  if (!answer.at_rest.factor)
    return answer;
  CapacityStop stop = path->begin();
  const std::string end = path->falls(answer.at_rest)
                              ? path->words_of_fall()
                              : take(stop, *answer.at_rest.factor);
  if (!end.empty())
    throw InputError("The capacity curve does not begin: " + end +
                     ". Change 'Capacity/Point', 'Capacity/Direction', or the "
                     "loads and strengths.");
  curve.points.push_back(stop.point);
  if (!curve.has_moving_supports)
    curve.participation = participation(stop.motion);
  follow(std::move(stop), curve);
  return answer;
}
} // namespace

CapacityAnswer find_capacity(const Scene &dead,
                             const Scene &live,
                             const CapacityWanted &wanted,
                             const LoadFactorControls &controls,
                             Terminal &terminal)
{
  return CapacitySearch(dead, live, wanted, controls, terminal).find();
}
} // namespace Voussoir
