// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/linear/joint_system.h>
#include <voussoir/analyses/capacity/capacity_curve.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/scene/positions.h>
#include <voussoir/scene/proofs/certificate.h>
#include <voussoir/scene/proofs/displacement_jumps.h>
#include <voussoir/statics/problem/discretise.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
using dealii::Tensor;

namespace
{
/** A jump of a mechanism, over its largest displacement, that is none. */
constexpr double least_jump_of_mechanism = 1e-7;
/**
 * The same of a motion that proves that no factor is carried, over its largest
 * opening: an interior point leaves a little of one in every joint.
 */
constexpr double least_opening_of_switch = 0.05;
/** The first step, over the size of a cell, behind which the others follow. */
constexpr double first_step = 1e-3;
/** The largest turn of a cell in a step; radians. */
constexpr double largest_turn = 0.1;
/** The error of joints that touch, over the size of a cell, and the rounds of
 * Newton's method that it takes. */
constexpr double error_of_contact = 1e-13;
constexpr unsigned int n_rounds_of_contact = 12;
/** The shift of its systems, which have the mechanism as a null space. */
constexpr double shift_of_contact = 1e-9;
/** The overlap of open ends, over the size of a cell, that ends a curve. */
constexpr double largest_overlap = 1e-9;
/** A factor, over that at rest, that is next to none; rounds to find it. */
constexpr double error_of_ultimate = 1e-9;
constexpr unsigned int n_rounds_of_ultimate = 12;
/** The most joints that a hinge goes over to in a step. */
constexpr unsigned int n_switches = 10;
/** The most steps, over the points that are wanted. */
constexpr unsigned int most_steps = 8;

/** One position, and what is known of it. */
struct Stop
{
  Positions positions;
  std::vector<std::array<bool, 2>> open;
  CapacityPoint point;
  /** The mechanism, in which the point goes at the speed one. */
  Motion mechanism;
};

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
        terminal(terminal),
        size(std::sqrt(dead.packing.area() / dead.packing.n_cells()))
  {}

  CapacityAnswer find();

private:
  double displacement_at(const Positions &positions) const
  {
    return (positions.of(dead.packing, wanted.cell, wanted.place) -
            wanted.place) *
           wanted.direction;
  }
  LoadFactorAnswer factor_at(const Stop &stop) const;
  std::string take(Stop &stop, const LoadFactor &factor) const;
  void close_contacts(Stop &stop) const;
  bool switch_hinges(const Motion &motion, Stop &stop) const;
  std::string go(const Stop &from, double step, Stop &to) const;
  double step_of(const Stop &stop, double wanted_step) const;
  void
  find_ultimate(const Stop &before, double step, CapacityCurve &curve) const;
  double participation(const Motion &mechanism) const;

  const Scene &dead, &live;
  const CapacityWanted &wanted;
  const LoadFactorControls &controls;
  Terminal &terminal;
  const double size;
};

LoadFactorAnswer CapacitySearch::factor_at(const Stop &stop) const
{
  return find_load_factor(moved_scene(dead, stop.positions, stop.open),
                          moved_scene(live, stop.positions, stop.open),
                          controls, Terminal::silent());
}

/**
 * Take the factor at a position, and which ends its mechanism opens.
 *
 * @return why the curve cannot go on; empty if it can.
 */
std::string CapacitySearch::take(Stop &stop, const LoadFactor &factor) const
{
  const Packing<2> here = moved_packing(dead.packing, stop.positions);
  stop.point = {displacement_at(stop.positions), factor.carried, factor.bound,
                0.};
  if (factor.is_unbounded || !factor.has_mechanism())
    return "there is no mechanism";
  Motion mechanism = factor.mechanism;
  const dealii::Point<2> place =
      stop.positions.of(dead.packing, wanted.cell, wanted.place);
  const double speed =
      mechanism.at(wanted.cell, place - here.centre(wanted.cell)) *
      wanted.direction;
  const InterfaceJumps jumps = jumps_of(here, mechanism);
  const double least = least_jump_of_mechanism * jumps.largest_displacement;
  if (!(std::abs(speed) > least))
    return "the point does not move in the mechanism";
  if (speed < 0.)
    return "the point goes the other way in the mechanism";
  for (unsigned int e = 0; e < jumps.sliding.size(); ++e)
  {
    std::array<bool, 2> &open = stop.open[e];
    if (open[0] && open[1])
      continue;
    if (std::abs(jumps.sliding[e]) > least)
      return text("blocks slide, at ",
                  text_of_point(here.interfaces()[e].midpoint()));
    for (unsigned int k = 0; k < 2; ++k)
      open[k] = open[k] || jumps.openings[e][k] > least;
  }
  for (Tensor<1, 2> &u : mechanism.displacement)
    u /= speed;
  for (double &angle : mechanism.rotation)
    angle /= speed;
  stop.mechanism = std::move(mechanism);
  return {};
}

/** Let ends that are not open touch, without sliding, by Newton's method. */
void CapacitySearch::close_contacts(Stop &stop) const
{
  for (unsigned int round = 0; round < n_rounds_of_contact; ++round)
  {
    const Scene here = moved_scene(dead, stop.positions, stop.open);
    const DiscreteProblem problem = discretise(here);
    const std::vector<MovedJoint> joints =
        moved_joints(dead.packing, stop.positions);
    std::vector<double> apart(problem.n_all_rows(), 0.);
    JointStiffnesses springs = {apart, false};
    double largest = 0.;
    for (unsigned int e = 0; e < joints.size(); ++e)
    {
      std::size_t row = problem.first_row(e);
      const auto add = [&](const double gap) {
        apart[row] = gap / problem.length_scale();
        springs.of_rows[row++] = 1.;
        largest = std::max(largest, std::abs(gap));
      };
      for (unsigned int k = 0; k < 2; ++k)
        if (!stop.open[e][k])
          add(joints[e].openings[k]);
      if (!(stop.open[e][0] && stop.open[e][1]))
        add(joints[e].sliding);
    }
    if (!(largest > error_of_contact * size))
      return;
    JointSystem system(problem, LinearSolver::automatic);
    std::vector<double> right(problem.n_dofs(), 0.);
    problem.add_jump_gradients(-1., apart, right);
    if (!system.prepare(springs, shift_of_contact))
      break;
    std::vector<double> correction = system.solve(right);
    problem.remove_rigid_motions(correction);
    stop.positions = stop.positions.advanced(
        dimensional_motion(problem, correction, problem.length_scale()), 1.);
  }
}

/** A step that turns no cell too much. */
double CapacitySearch::step_of(const Stop &stop, const double wanted_step) const
{
  double fastest = 0.;
  for (const double angle : stop.mechanism.rotation)
    fastest = std::max(fastest, std::abs(angle));
  return fastest > 0. ? std::min(wanted_step, largest_turn / fastest)
                      : wanted_step;
}

/**
 * Go along a motion that no factor holds back until an end that is open closes:
 * a hinge goes over to another joint.
 *
 * @return false if none closes.
 */
bool CapacitySearch::switch_hinges(const Motion &motion, Stop &stop) const
{
  const InterfaceJumps rates =
      jumps_of(moved_packing(dead.packing, stop.positions), motion);
  double largest = 0.;
  for (const auto &of_joint : rates.openings)
    for (const double rate : of_joint)
      largest = std::max(largest, std::abs(rate));
  const double least = least_opening_of_switch * largest;
  const std::vector<MovedJoint> joints =
      moved_joints(dead.packing, stop.positions);
  double first = std::numeric_limits<double>::infinity();
  std::pair<unsigned int, unsigned int> closes;
  std::vector<std::array<bool, 2>> open = stop.open;
  for (unsigned int e = 0; e < joints.size(); ++e)
    for (unsigned int k = 0; k < 2; ++k)
    {
      const double rate = rates.openings[e][k];
      if (!stop.open[e][k])
        open[e][k] = rate > least;
      else if (rate < -least && joints[e].openings[k] / -rate < first)
      {
        first = joints[e].openings[k] / -rate;
        closes = {e, k};
      }
    }
  if (!std::isfinite(first))
    return false;
  open[closes.first][closes.second] = false;
  stop.open = std::move(open);
  stop.positions = stop.positions.advanced(motion, first);
  close_contacts(stop);
  return true;
}

/**
 * Go on along the mechanism.
 *
 * @param to takes the next position.
 * @return why the curve ends there; empty if it goes on.
 */
std::string
CapacitySearch::go(const Stop &from, const double step, Stop &to) const
{
  to.positions = from.positions.advanced(from.mechanism, step);
  to.open = from.open;
  close_contacts(to);
  const std::vector<MovedJoint> joints =
      moved_joints(dead.packing, to.positions);
  for (unsigned int e = 0; e < joints.size(); ++e)
    for (unsigned int k = 0; k < 2; ++k)
      if (joints[e].openings[k] < -largest_overlap * size)
        return text("blocks meet again, at ",
                    text_of_point(dead.packing.interfaces()[e].midpoint()),
                    " at rest");
  LoadFactorAnswer answer;
  try
  {
    answer = factor_at(to);
    for (unsigned int k = 0;
         k < n_switches && !answer.factor && switch_hinges(answer.collapse, to);
         ++k)
      answer = factor_at(to);
  }
  catch (const SolverError &)
  {
    return "no factor is found any more";
  }
  if (!answer.factor)
    return "no factor is carried any more";
  const double error = certify(moved_scene(dead, to.positions, to.open, &live,
                                           answer.factor->carried),
                               answer.factor->forces)
                           .error();
  const std::string end = take(to, *answer.factor);
  to.point.error_of_state = error;
  return end;
}

/**
 * Where the factor is next to zero, behind a position where it is not yet, and
 * before one where it is less: something is still carried there.
 */
void CapacitySearch::find_ultimate(const Stop &before,
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
    Stop stop = before;
    go(before, at, stop);
    if (!(stop.point.displacement > before.point.displacement))
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

CapacityAnswer CapacitySearch::find()
{
  CapacityAnswer answer;
  CapacityCurve &curve = answer.curve;
  curve.ultimate = std::numeric_limits<double>::quiet_NaN();
  const unsigned int n = dead.packing.n_cells();
  Stop stop = {Positions(n),
               std::vector<std::array<bool, 2>>(
                   dead.packing.interfaces().size(), {{false, false}}),
               {},
               {}};
  answer.at_rest = find_load_factor(dead, live, controls, terminal);
  if (!answer.at_rest.factor)
    return answer;
  std::string end = take(stop, *answer.at_rest.factor);
  if (!end.empty())
    throw InputError("The capacity curve does not begin: " + end +
                     ". Change 'Capacity/Point', 'Capacity/Direction', or the "
                     "loads and strengths.");
  curve.points.push_back(stop.point);
  curve.participation = participation(stop.mechanism);
  double step = first_step * size;
  for (unsigned int k = 0; k < most_steps * wanted.n_points; ++k)
  {
    Stop next = stop;
    const double length = step_of(stop, step);
    end = go(stop, length, next);
    if (!end.empty() && !(next.point.displacement > stop.point.displacement))
      break;
    curve.points.push_back(next.point);
    terminal.iteration("Capacity",
                       text("displacement ", next.point.displacement,
                            ", factor ", next.point.carried));
    if (next.point.carried <= 0.)
    {
      find_ultimate(stop, length, curve);
      end = "the factor is zero";
      break;
    }
    if (!end.empty())
      break;
    if (wanted.largest > 0. && next.point.displacement >= wanted.largest)
    {
      end = "the displacement is that of 'Capacity/Largest displacement'";
      break;
    }
    // As far as a line through the last two points goes.
    const double slope = (stop.point.carried - next.point.carried) /
                         (next.point.displacement - stop.point.displacement);
    const double first = curve.points.front().carried;
    const double whole = wanted.largest > 0. ? wanted.largest
                         : slope > 0.        ? first / slope
                                             : 100. * size;
    step = whole / wanted.n_points;
    if (wanted.largest > 0.)
      step = std::min(step, wanted.largest - next.point.displacement);
    stop = std::move(next);
  }
  curve.end = end.empty() ? "there are many steps" : end;
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
