// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/linear/joint_system.h>
#include <voussoir/analyses/capacity/placement.h>
#include <voussoir/statics/problem/discretise.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
namespace
{
/**
 * An opening, over the largest one, of a motion that nothing holds back: an
 * interior point leaves a little of one in every joint.
 */
constexpr double least_opening_of_switch = 0.05;
/** The error of joints that touch, over the size of a cell, and the rounds of
 * Newton's method, or of the secant method, that it takes. */
constexpr double error_of_contact = 1e-13;
constexpr unsigned int n_rounds_of_contact = 12;
/** The shift of its systems, which have the mechanism as a null space. */
constexpr double shift_of_contact = 1e-9;
/** The overlap of open ends, over the size of a cell, that is none. */
constexpr double largest_overlap = 1e-9;
} // namespace

Placement::Placement(const Scene &at_rest,
                     std::vector<SupportMotion> of_supports)
    : scene(&at_rest),
      size(std::sqrt(at_rest.packing.area() / at_rest.packing.n_cells())),
      of_supports(std::move(of_supports)), places(at_rest.packing.n_cells()),
      open(at_rest.packing.interfaces().size(), {{false, false}})
{}

std::optional<unsigned int> Placement::open_ends_of(const InterfaceJumps &jumps,
                                                    const double least)
{
  for (unsigned int e = 0; e < open.size(); ++e)
  {
    if (open[e][0] && open[e][1])
      continue;
    if (std::abs(jumps.sliding[e]) > least)
      return e;
    for (unsigned int k = 0; k < 2; ++k)
      open[e][k] = open[e][k] || jumps.openings[e][k] > least;
  }
  return {};
}

/** Let ends that are not open touch, without sliding, by Newton's method. */
void Placement::close_contacts()
{
  for (unsigned int round = 0; round < n_rounds_of_contact; ++round)
  {
    const DiscreteProblem problem = discretise(moved(*scene));
    const std::vector<MovedJoint> apart = joints();
    std::vector<double> jumps(problem.n_all_rows(), 0.);
    JointStiffnesses springs = {jumps, false};
    double largest = 0.;
    for (unsigned int e = 0; e < apart.size(); ++e)
    {
      std::size_t row = problem.first_row(e);
      const auto add = [&](const double gap) {
        jumps[row] = gap / problem.length_scale();
        springs.of_rows[row++] = 1.;
        largest = std::max(largest, std::abs(gap));
      };
      for (unsigned int k = 0; k < 2; ++k)
        if (!open[e][k])
          add(apart[e].openings[k]);
      if (!(open[e][0] && open[e][1]))
        add(apart[e].sliding);
    }
    if (!(largest > error_of_contact * size))
      return;
    JointSystem system(problem, LinearSolver::automatic);
    std::vector<double> right(problem.n_dofs(), 0.);
    problem.add_jump_gradients(-1., jumps, right);
    if (!system.prepare(springs, shift_of_contact))
      break;
    std::vector<double> correction = system.solve(right);
    problem.remove_rigid_motions(correction);
    places = places.advanced(
        dimensional_motion(problem, correction, problem.length_scale()), 1.);
  }
}

/**
 * The open end that closes first between the joints @p before and these.
 *
 * @param step is shortened to where that is, on a straight line.
 */
std::optional<Placement::End>
Placement::first_overlap(const std::vector<MovedJoint> &before,
                         double &step) const
{
  std::optional<End> first;
  double share = 1.;
  const std::vector<MovedJoint> after = joints();
  for (unsigned int e = 0; e < after.size(); ++e)
    for (unsigned int k = 0; k < 2; ++k)
    {
      const double gap = after[e].openings[k];
      if (!open[e][k] || gap >= -largest_overlap * size)
        continue;
      const double gap_before = std::max(before[e].openings[k], 0.);
      const double at = gap_before / (gap_before - gap);
      if (at < share)
      {
        share = at;
        first = {e, k};
      }
    }
  step *= share;
  return first;
}

/** Be where a motion leads to in a step, with the ends that touch here. */
void Placement::go(const Placement &from,
                   const Motion &motion,
                   const double step)
{
  places = from.places.advanced(motion, step);
  gone = from.gone + step;
  places.of_supports = of_supports;
  for (SupportMotion &of : places.of_supports)
  {
    of.displacement *= gone;
    of.rotation *= gone;
  }
  close_contacts();
}

void Placement::advance(const Motion &motion, const double step)
{
  const Placement from = *this;
  go(from, motion, step);
  double at = step;
  const std::optional<End> closing = first_overlap(from.joints(), at);
  if (!closing)
    return;
  double last = step, gap_of_last = opening_of(*closing);
  for (unsigned int round = 0; round < n_rounds_of_contact; ++round)
  {
    go(from, motion, at);
    const double gap = opening_of(*closing);
    if (std::abs(gap) <= error_of_contact * size || gap == gap_of_last)
      break;
    const double next = at - gap * (at - last) / (gap - gap_of_last);
    last = at;
    gap_of_last = gap;
    at = std::min(std::max(next, 0.), step);
  }
  open[closing->first][closing->second] = false;
}

bool Placement::switch_hinges(const Motion &motion)
{
  const InterfaceJumps rates = jumps_of(packing(), motion);
  double largest = 0.;
  for (const auto &of_joint : rates.openings)
    for (const double rate : of_joint)
      largest = std::max(largest, std::abs(rate));
  const double least = least_opening_of_switch * largest;
  const std::vector<MovedJoint> apart = joints();
  double first = std::numeric_limits<double>::infinity();
  End closes;
  std::vector<std::array<bool, 2>> opened = open;
  for (unsigned int e = 0; e < apart.size(); ++e)
    for (unsigned int k = 0; k < 2; ++k)
    {
      const double rate = rates.openings[e][k];
      if (!open[e][k])
        opened[e][k] = rate > least;
      else if (rate < -least && apart[e].openings[k] / -rate < first)
      {
        first = apart[e].openings[k] / -rate;
        closes = {e, k};
      }
    }
  if (!std::isfinite(first))
    return false;
  opened[closes.first][closes.second] = false;
  open = std::move(opened);
  places = places.advanced(motion, first);
  close_contacts();
  return true;
}
} // namespace Voussoir
