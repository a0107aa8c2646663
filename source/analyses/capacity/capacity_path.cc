// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/capacity/capacity_path.h>
#include <voussoir/analyses/ranges/settlement.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Voussoir
{
namespace
{
/** A speed in a mechanism, over its largest displacement, that is none. */
constexpr double least_speed = 1e-7;
/** The first step, over the size of a cell, behind which the others follow. */
constexpr double first_step_of_mechanism = 1e-3;
/** Where there is no slope, the whole length of the curve over that size. */
constexpr double length_without_slope = 100.;
/** The error of the last place of supports, over the way that they go. */
constexpr double error_on_way = 1e-9;

/** Along the mechanism of the factor, until that is zero. */
class MechanismPath : public CapacityPath
{
public:
  MechanismPath(const Scene &dead, const CapacityWanted &wanted)
      : CapacityPath(dead, wanted),
        size(std::sqrt(dead.packing.area() / dead.packing.n_cells()))
  {}
  bool falls(const LoadFactorAnswer &answer) const override
  {
    return !answer.factor;
  }
  std::string words_of_fall() const override
  {
    return "no factor is carried any more";
  }
  std::string take(CapacityStop &stop, const LoadFactor &factor) const override;
  double first_step() const override { return first_step_of_mechanism * size; }
  double next_step(const std::vector<CapacityPoint> &points,
                   const CapacityStop &last) const override;
  double error_of_last_place() const override { return 0.; }

private:
  const double size;
};

/** Take the mechanism of the factor, in which the point goes forward. */
std::string MechanismPath::take(CapacityStop &stop,
                                const LoadFactor &factor) const
{
  if (factor.is_unbounded || !factor.has_mechanism())
    return "there is no mechanism";
  const Packing<2> here = stop.place.packing();
  stop.motion = factor.mechanism;
  const double speed =
      stop.motion.at(wanted.cell,
                     place_of_point(stop) - here.centre(wanted.cell)) *
      wanted.direction;
  stop.jumps = jumps_of(here, stop.motion);
  const double least = least_speed * stop.jumps.largest_displacement;
  if (!(std::abs(speed) > least))
    return "the point does not move in the mechanism";
  if (speed < 0.)
    return "the point goes the other way in the mechanism";
  stop.motion = times(std::move(stop.motion), 1. / speed);
  return {};
}

double MechanismPath::next_step(const std::vector<CapacityPoint> &points,
                                const CapacityStop &) const
{
  // As far as a line through the last two points goes.
  const CapacityPoint &last = points.back();
  const CapacityPoint &before = points[points.size() - 2];
  const double slope = (before.carried - last.carried) /
                       (last.displacement - before.displacement);
  const double whole = wanted.largest > 0. ? wanted.largest
                       : slope > 0.        ? points.front().carried / slope
                                           : length_without_slope * size;
  const double step = whole / wanted.n_points;
  return wanted.largest > 0.
             ? std::min(step, wanted.largest - last.displacement)
             : step;
}

/** How far supports move at their ends; L. */
double largest_of(const Packing<2> &packing, const Positions &positions)
{
  double largest = 0.;
  const unsigned int n = packing.interfaces().size();
  for (unsigned int e = n - packing.n_supports(); e < n; ++e)
    for (const dealii::Point<2> &x :
         {packing.interfaces()[e].start, packing.interfaces()[e].end})
      largest =
          std::max(largest, (positions.of_ground(packing, e, x) - x).norm());
  return largest;
}

/** With the supports, while the dead loads are carried. */
class SupportPath : public CapacityPath
{
public:
  SupportPath(const Scene &dead, const CapacityWanted &wanted)
      : CapacityPath(dead, wanted),
        way(largest_of(dead.packing, whole(dead, wanted)))
  {}
  bool falls(const LoadFactorAnswer &answer) const override
  {
    return !answer.factor || answer.factor->collapses_without;
  }
  std::string words_of_fall() const override
  {
    return "the dead loads are not carried";
  }
  CapacityStop begin() const override
  {
    std::vector<SupportMotion> in_a_step = wanted.of_supports;
    for (SupportMotion &of : in_a_step)
    {
      of.displacement /= way;
      of.rotation /= way;
    }
    return {Placement(dead, std::move(in_a_step))};
  }
  std::string take(CapacityStop &stop, const LoadFactor &factor) const override;
  double first_step() const override { return way / wanted.n_points; }
  double next_step(const std::vector<CapacityPoint> &,
                   const CapacityStop &last) const override
  {
    return std::min(first_step(), way - last.place.way());
  }
  std::string end_at(const CapacityStop &stop) const override
  {
    return way - stop.place.way() <= error_of_last_place()
               ? "the supports have moved as 'Supports/Displacement' says"
               : CapacityPath::end_at(stop);
  }
  double error_of_last_place() const override { return error_on_way * way; }

private:
  /** Where the supports go in all. */
  static Positions whole(const Scene &dead, const CapacityWanted &wanted)
  {
    Positions positions(dead.packing.n_cells());
    positions.of_supports = wanted.of_supports;
    return positions;
  }
  /** How far the support goes in all that goes farthest; L. */
  const double way;
};

/** Take the motion of the blocks with the supports. */
std::string SupportPath::take(CapacityStop &stop, const LoadFactor &) const
{
  const Positions &positions = stop.place.positions();
  stop.point.of_supports = largest_of(dead.packing, positions);
  const Scene here = stop.place.moved(dead);
  const unsigned int first =
      here.packing.interfaces().size() - here.packing.n_supports();
  std::vector<SupportMotion> of_supports = wanted.of_supports;
  for (unsigned int k = 0; k < of_supports.size(); ++k)
  {
    const dealii::Point<2> at_rest =
        dead.packing.interfaces()[first + k].midpoint();
    of_supports[k].displacement = of_supports[k].at(
        here.packing.interfaces()[first + k].midpoint() -
        positions.of_ground(dead.packing, first + k, at_rest));
  }
  const Settlement found = find_settlement(here, of_supports);
  stop.point.support_force = -found.work / found.largest_displacement;
  stop.point.least_support_force =
      -(found.work + found.width) / found.largest_displacement;
  stop.jumps = jumps_of(here.packing, found.motion);
  stop.motion = times(found.motion, 1. / way);
  return {};
}
} // namespace

std::unique_ptr<const CapacityPath>
make_capacity_path(const Scene &dead, const CapacityWanted &wanted)
{
  if (wanted.of_supports.empty())
    return std::make_unique<MechanismPath>(dead, wanted);
  return std::make_unique<SupportPath>(dead, wanted);
}
} // namespace Voussoir
