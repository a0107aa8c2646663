// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/formula/formula.h>

#include <boost/logic/tribool.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace Voussoir
{
namespace
{
/** The size beyond which doubles are integers. */
constexpr double largest_step = 1e15;

/** The side of its level that an argument is on, if that is known. */
enum class Side
{
  below = -1,
  at = 0,
  above = 1,
  unknown
};

bool has_slopes(const Bounds &bounds)
{
  return std::isfinite(magnitude(bounds.slope[0]) + magnitude(bounds.slope[1]));
}

/**
 * The side of zero. A smooth value that touches zero, or is equal to it, is so
 * on a set of measure zero, unless it is zero altogether. A value that may
 * jump, and so has no slopes, is known when it is cut.
 */
Side side(const Bounds &distance)
{
  const Interval &value = distance.value;
  if (is_zero(value))
    return Side::at;
  if (excludes_zero(value) || has_slopes(distance))
    return value.upper() <= 0.   ? Side::below
           : value.lower() >= 0. ? Side::above
                                 : Side::unknown;
  return Side::unknown;
}

/**
 * A level strictly inside an interval, if there is one, near its middle: of a
 * function whose levels are at first_step + k period.
 */
std::optional<double>
level_inside(const Interval &a, const double first_step, const double period)
{
  double level = first_step;
  if (period > 0.)
  {
    const double middle = 0.5 * (std::max(a.lower(), -largest_step) +
                                 std::min(a.upper(), largest_step));
    level += period * std::floor((middle - first_step) / period);
    if (!(level > a.lower()))
      level += period;
  }
  return a.lower() < level && level < a.upper() ? std::optional<double>(level)
                                                : std::nullopt;
}

/**
 * The range of a function by its bounds, and by the mean value theorem, which
 * is closer where a variable occurs more than once.
 *
 * @param middle its value at the centre.
 */
Interval closer_range(const Bounds &bounds, const double middle)
{
  const double reach = magnitude(bounds.slope[0]) + magnitude(bounds.slope[1]);
  if (!std::isfinite(reach) || !std::isfinite(middle))
    return bounds.value;
  const double lower = std::max(bounds.value.lower(), middle - reach);
  const double upper = std::min(bounds.value.upper(), middle + reach);
  return lower <= upper ? Interval(lower, upper) : Interval(middle);
}

/** The level that all of an interval is equal to but for rounding, if any. */
std::optional<double> level_beside(const Interval &a,
                                   const double first_step,
                                   const double period,
                                   const double scale)
{
  constexpr double rounding = 1e-14;
  double level = first_step;
  if (period > 0.)
    level += period * std::rint((a.lower() - first_step) / period);
  const double distance = magnitude(a - level);
  return distance > 0. && distance <= rounding * scale
             ? std::optional<double>(level)
             : std::nullopt;
}

/** True or false of what may be either from place to place. */
using boost::logic::tribool;

/** The truth of a value: not zero, but for a set of measure zero. */
tribool truth(const Bounds &bounds, const double middle)
{
  if (is_zero(closer_range(bounds, middle)))
    return false;
  return excludes_zero(bounds.value) || has_slopes(bounds)
             ? tribool(true)
             : boost::logic::indeterminate;
}

Bounds bounds_of_truth(const tribool truth)
{
  return indeterminate(truth) ? either({0., {}}, {1., {}})
                              : Bounds{truth ? 1. : 0., {}};
}
} // namespace

/** From the bounds of its operands, within a limit. */
Bounds Formula::argument_bounds(const Node &node, const Interval &limit) const
{
  Bounds bounds = node_bounds[node.operand[0]];
  if (node.kind != Kind::stepped && node.kind != Kind::angle)
    bounds = bounds - node_bounds[node.operand[1]];
  const Interval range = closer_range(bounds, argument_of(node));
  double lower = std::max(range.lower(), limit.lower());
  double upper = std::min(range.upper(), limit.upper());
  // By rounding it may be beyond a limit; then it is strictly within.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (lower > upper && lower > limit.upper())
    lower = std::nextafter(upper, -infinity);
  else if (lower > upper)
    upper = std::nextafter(lower, infinity);
  bounds.value = Interval(lower, upper);
  return bounds;
}

Bounds Formula::bounds_of_jump(const Node &node, const Bounds &argument) const
{
  const Bounds &a = node_bounds[node.operand[0]];
  const Bounds &b = node_bounds[node.operand[1]];
  const Side where = side(argument);
  switch (node.kind)
  {
  case Kind::less:
  case Kind::less_equal:
  case Kind::greater:
  case Kind::greater_equal: // as of numbers on that side of zero, and zero
    return bounds_of_truth(
        where == Side::unknown
            ? tribool(boost::logic::indeterminate)
            : tribool(apply(node, static_cast<int>(where), 0., 0.) != 0.));
  case Kind::minimum:
    return where == Side::unknown ? either(a, b) : where == Side::above ? b : a;
  case Kind::maximum:
    return where == Side::unknown ? either(a, b) : where == Side::below ? b : a;
  case Kind::angle: // with a step on the negative axis
    return where == Side::unknown && !(b.value.lower() >= 0.)
               ? either(atan2(a, b), atan2(a, b))
               : atan2(a, b);
  default: break;
  }
  // A stepped function increases, but for abs.
  const SteppedFunction &function = stepped_functions()[node.number];
  if (function.name == "abs")
    return where == Side::unknown ? either(-argument, argument)
           : where == Side::below ? -argument
                                  : argument;
  if (level_inside(argument.value, function.first_step, function.period))
    return either({function.value(argument.value.lower()), {}},
                  {function.value(argument.value.upper()), {}});
  return {
      function.value(0.5 * (argument.value.lower() + argument.value.upper())),
      {}};
}

/** The bounds of an operation that has no jump. */
Bounds Formula::bounds_of(const Node &node) const
{
  const Bounds &a = node_bounds[node.operand[0]];
  const Bounds &b = node_bounds[node.operand[1]];
  const Bounds &c = node_bounds[node.operand[2]];
  const auto truth_of = [&](const unsigned int k) {
    return truth(node_bounds[node.operand[k]], node_values[node.operand[k]]);
  };
  const auto differ = [&] {
    return truth(a - b,
                 node_values[node.operand[0]] - node_values[node.operand[1]]);
  };
  switch (node.kind)
  {
  case Kind::negative: return -a;
  case Kind::add: return a + b;
  case Kind::subtract: return a - b;
  case Kind::multiply: return a * b;
  case Kind::divide: return a / b;
  case Kind::power: return pow(a, b);
  case Kind::equal: return bounds_of_truth(!differ());
  case Kind::not_equal: return bounds_of_truth(differ());
  case Kind::both: return bounds_of_truth(truth_of(0) && truth_of(1));
  case Kind::any: return bounds_of_truth(truth_of(0) || truth_of(1));
  case Kind::choose: return truth_of(0) ? b : !truth_of(0) ? c : either(b, c);
  case Kind::smooth: return smooth_functions()[node.number].bounds(a);
  default: return {node.constant, {}};
  }
}

/**
 * The value at the centre of the box of what has no jump, true to its bounds
 * also where the centre is on a curve on which a comparison is an equality.
 */
double Formula::middle_of(const Node &node, const Bounds &bounds) const
{
  if (singleton(bounds.value))
    return bounds.value.lower();
  if (node.kind != Kind::choose)
    return apply(node, node_values[node.operand[0]],
                 node_values[node.operand[1]], node_values[node.operand[2]]);
  const tribool which =
      truth(node_bounds[node.operand[0]], node_values[node.operand[0]]);
  return node_values[node.operand[!which ? 2 : 1]];
}

/**
 * The value of a jump at the centre of the box, on the side where @p argument
 * is known to be: the centre itself may be beyond a limit.
 */
void Formula::evaluate_branch(const unsigned int i,
                              const Bounds &argument,
                              const std::vector<double> &middle) const
{
  const Node &node = nodes[i];
  const Side where = side(argument);
  const double a = node_values[node.operand[0]];
  const double b = node_values[node.operand[1]];
  if (singleton(node_bounds[i].value))
    node_values[i] = node_bounds[i].value.lower();
  else if (where == Side::unknown || node.kind == Kind::angle)
    evaluate(i, i + 1, middle);
  else if (node.kind == Kind::stepped) // abs
    node_values[i] = where == Side::below ? -a : a;
  else
    node_values[i] =
        (node.kind == Kind::minimum) == (where == Side::above) ? b : a;
}

/** Mark the nodes on which the value depends in the last box. */
void Formula::mark_needed() const
{
  std::fill(needed.begin(), needed.end(), false);
  needed.back() = true;
  for (unsigned int i = nodes.size(); i-- > 0;)
  {
    if (!needed[i])
      continue;
    const Node &node = nodes[i];
    const auto mark = [&](const unsigned int k) {
      needed[node.operand[k]] = true;
    };
    const auto truth_of = [&](const unsigned int k) {
      return truth(node_bounds[node.operand[k]], node_values[node.operand[k]]);
    };
    // An operand that alone makes out the value.
    const auto decides = [&](const unsigned int k) {
      return node.kind == Kind::multiply
                 ? is_zero(node_bounds[node.operand[k]].value)
                 : bool(node.kind == Kind::any ? truth_of(k) : !truth_of(k));
    };
    switch (node.kind)
    {
    case Kind::choose:
      mark(0);
      if (!bool(!truth_of(0)))
        mark(1);
      if (!bool(truth_of(0)))
        mark(2);
      break;
    case Kind::multiply:
    case Kind::both:
    case Kind::any:
      for (unsigned int k = 0; k < 2; ++k)
        if (decides(k) || !decides(1 - k))
          mark(k);
      break;
    default:
      for (unsigned int k = 0; k < n_operands(node.kind); ++k)
        mark(k);
    }
  }
}

std::optional<double> Formula::level_of(const unsigned int jump,
                                        const Interval &limit) const
{
  const Node &node = nodes[jump_nodes[jump]];
  double first_step = 0., period = 0.;
  if (node.kind == Kind::stepped)
  {
    first_step = stepped_functions()[node.number].first_step;
    period = stepped_functions()[node.number].period;
  }
  const Interval &argument = arguments[jump].value;
  const auto level = level_inside(argument, first_step, period);
  if (level || std::isfinite(limit.lower()) || std::isfinite(limit.upper()))
    return level;
  return level_beside(argument, first_step, period,
                      magnitude(node_bounds[node.operand[0]].value));
}

Formula::Crossing Formula::crossing(const unsigned int jump,
                                    const double level) const
{
  const Node &node = nodes[jump_nodes[jump]];
  const double scale = magnitude(node_bounds[node.operand[0]].value) +
                       (node.kind == Kind::stepped
                            ? std::abs(level)
                            : magnitude(node_bounds[node.operand[1]].value));
  return {jump, level, arguments[jump] - Bounds{level, {}}, scale};
}

Bounds Formula::bounds(const std::vector<Bounds> &variables,
                       const std::vector<double> &middle,
                       const Limits &limits,
                       std::vector<Crossing> &crossings) const
{
  for (unsigned int i = 0; i < nodes.size(); ++i)
  {
    const Node &node = nodes[i];
    Bounds &here = node_bounds[i];
    if (node.jump != invalid_index)
    {
      arguments[node.jump] = argument_bounds(node, limits[node.jump]);
      here = bounds_of_jump(node, arguments[node.jump]);
      evaluate_branch(i, arguments[node.jump], middle);
      continue;
    }
    const bool is_variable = node.kind == Kind::variable;
    here = is_variable ? variables[node.number] : bounds_of(node);
    node_values[i] = is_variable ? middle[node.number] : middle_of(node, here);
    here.value = closer_range(here, node_values[i]);
  }

  mark_needed();
  for (unsigned int jump = 0; jump < n_jumps(); ++jump)
    if (needed[jump_nodes[jump]])
      if (const auto level = level_of(jump, limits[jump]))
        crossings.push_back(crossing(jump, *level));
  return node_bounds.back();
}
} // namespace Voussoir
