// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/formula/formula.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace Voussoir
{
namespace
{
constexpr unsigned int none = static_cast<unsigned int>(-1);

/** Beyond it doubles are integers. */
constexpr double largest_step = 1e15;

/** Which side of its level an argument is on, if that is known. */
enum class Side
{
  below,
  at,
  above,
  unknown
};

/** A boundary that touches the level is of measure zero. */
Side side(const Interval &distance)
{
  if (is_zero(distance))
    return Side::at;
  return distance.upper() <= 0.   ? Side::below
         : distance.lower() >= 0. ? Side::above
                                  : Side::unknown;
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

Bounds unknown_truth()
{
  return either({0., {}}, {1., {}});
}
} // namespace

unsigned int Formula::n_operands(const Kind kind)
{
  switch (kind)
  {
  case Kind::constant:
  case Kind::variable:
    return 0;
  case Kind::negative:
  case Kind::smooth:
  case Kind::stepped:
    return 1;
  case Kind::choose:
    return 3;
  default:
    return 2;
  }
}

bool Formula::has_jump(const Kind kind)
{
  switch (kind)
  {
  case Kind::less:
  case Kind::less_equal:
  case Kind::greater:
  case Kind::greater_equal:
  case Kind::stepped:
  case Kind::minimum:
  case Kind::maximum:
  case Kind::angle:
    return true;
  default: // == and != differ from a constant on curves only
    return false;
  }
}

double
Formula::apply(const Node &node, const double a, const double b, const double c)
{
  switch (node.kind)
  {
  case Kind::constant:
  case Kind::variable:
    return node.constant;
  case Kind::negative:
    return -a;
  case Kind::add:
    return a + b;
  case Kind::subtract:
    return a - b;
  case Kind::multiply:
    return a * b;
  case Kind::divide:
    return a / b;
  case Kind::power:
    return std::pow(a, b);
  case Kind::less:
    return a < b;
  case Kind::less_equal:
    return a <= b;
  case Kind::greater:
    return a > b;
  case Kind::greater_equal:
    return a >= b;
  case Kind::equal:
    return a == b;
  case Kind::not_equal:
    return a != b;
  case Kind::both:
    return a != 0. && b != 0.;
  case Kind::any:
    return a != 0. || b != 0.;
  case Kind::choose:
    return a != 0. ? b : c;
  case Kind::smooth:
    return smooth_functions()[node.number].value(a);
  case Kind::stepped:
    return stepped_functions()[node.number].value(a);
  case Kind::minimum:
    return std::min(a, b);
  case Kind::maximum:
    return std::max(a, b);
  case Kind::angle:
    return std::atan2(a, b);
  }
  return 0.;
}

void Formula::evaluate(const unsigned int begin,
                       const unsigned int end,
                       const std::vector<double> &values) const
{
  for (unsigned int i = begin; i < end; ++i)
  {
    const Node &node = nodes[i];
    node_values[i] =
        node.kind == Kind::variable
            ? values[node.number]
            : apply(node, node_values[node.operand[0]],
                    node_values[node.operand[1]], node_values[node.operand[2]]);
  }
}

/** From the values of its operands. */
double Formula::argument_of(const Node &node) const
{
  const double a = node_values[node.operand[0]];
  return node.kind == Kind::stepped || node.kind == Kind::angle
             ? a
             : a - node_values[node.operand[1]];
}

double Formula::value(const std::vector<double> &values) const
{
  evaluate(0, nodes.size(), values);
  return node_values.back();
}

double Formula::argument(const unsigned int jump,
                         const std::vector<double> &values) const
{
  const Node &node = nodes[jump_nodes[jump]];
  evaluate(node.first, jump_nodes[jump], values);
  return argument_of(node);
}

/**
 * From the bounds of its operands: also by the mean value theorem, which is
 * closer where a variable occurs more than once.
 */
Bounds Formula::argument_bounds(const Node &node, const Interval &limit) const
{
  Bounds bounds = node_bounds[node.operand[0]];
  if (node.kind != Kind::stepped && node.kind != Kind::angle)
    bounds = bounds - node_bounds[node.operand[1]];
  const double reach = magnitude(bounds.slope[0]) + magnitude(bounds.slope[1]);
  const double middle = argument_of(node);
  double lower = bounds.value.lower(), upper = bounds.value.upper();
  if (std::isfinite(reach) && std::isfinite(middle))
  {
    lower = std::max(lower, middle - reach);
    upper = std::min(upper, middle + reach);
  }
  lower = std::max(lower, limit.lower());
  upper = std::min(upper, limit.upper());
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
  const Side where = side(argument.value);
  const auto truth = [&](const bool below, const bool at, const bool above) {
    return where == Side::unknown ? unknown_truth()
                                  : Bounds{double(where == Side::below ? below
                                                  : where == Side::at  ? at
                                                                       : above),
                                           {}};
  };
  switch (node.kind)
  {
  case Kind::less:
    return truth(true, false, false);
  case Kind::less_equal:
    return truth(true, true, false);
  case Kind::greater:
    return truth(false, false, true);
  case Kind::greater_equal:
    return truth(false, true, true);
  case Kind::minimum:
    return where == Side::unknown ? either(a, b) : where == Side::above ? b : a;
  case Kind::maximum:
    return where == Side::unknown ? either(a, b) : where == Side::below ? b : a;
  case Kind::angle:
    return atan2(a, b);
  default:
    break;
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

/** Of what has no jump. */
Bounds Formula::bounds_of(const Node &node) const
{
  const Bounds &a = node_bounds[node.operand[0]];
  const Bounds &b = node_bounds[node.operand[1]];
  const auto is_true = [](const Bounds &x) {
    return excludes_zero(x.value);
  };
  switch (node.kind)
  {
  case Kind::negative:
    return -a;
  case Kind::add:
    return a + b;
  case Kind::subtract:
    return a - b;
  case Kind::multiply:
    return a * b;
  case Kind::divide:
    return a / b;
  case Kind::power:
    return pow(a, b);
  case Kind::equal:
  case Kind::not_equal: {
    const Interval difference = (a - b).value;
    if (!is_zero(difference) && !excludes_zero(difference))
      return unknown_truth();
    return {double(is_zero(difference) == (node.kind == Kind::equal)), {}};
  }
  case Kind::both:
    return is_zero(a.value) || is_zero(b.value) ? Bounds{0., {}}
           : is_true(a) && is_true(b)           ? Bounds{1., {}}
                                                : unknown_truth();
  case Kind::any:
    return is_true(a) || is_true(b)               ? Bounds{1., {}}
           : is_zero(a.value) && is_zero(b.value) ? Bounds{0., {}}
                                                  : unknown_truth();
  case Kind::choose:
    return is_true(a)         ? b
           : is_zero(a.value) ? node_bounds[node.operand[2]]
                              : either(b, node_bounds[node.operand[2]]);
  case Kind::smooth:
    return smooth_functions()[node.number].bounds(a);
  default:
    return {node.constant, {}};
  }
}

/** Which nodes the value depends on in the last box. */
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
    const auto is_false = [&](const unsigned int k) {
      return is_zero(node_bounds[node.operand[k]].value);
    };
    const auto is_true = [&](const unsigned int k) {
      return excludes_zero(node_bounds[node.operand[k]].value);
    };
    const auto decides = [&](const unsigned int k) {
      return node.kind == Kind::any ? is_true(k) : is_false(k);
    };
    switch (node.kind)
    {
    case Kind::choose:
      mark(0);
      if (!is_false(0))
        mark(1);
      if (!is_true(0))
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

Bounds Formula::bounds(const std::vector<Bounds> &variables,
                       const std::vector<double> &middle,
                       const Limits &limits,
                       std::vector<Crossing> &crossings) const
{
  evaluate(0, nodes.size(), middle);
  for (unsigned int i = 0; i < nodes.size(); ++i)
  {
    const Node &node = nodes[i];
    if (node.kind == Kind::variable)
      node_bounds[i] = variables[node.number];
    else if (node.jump == none)
      node_bounds[i] = bounds_of(node);
    else
    {
      arguments[node.jump] = argument_bounds(node, limits[node.jump]);
      node_bounds[i] = bounds_of_jump(node, arguments[node.jump]);
    }
  }

  mark_needed();
  for (unsigned int jump = 0; jump < n_jumps(); ++jump)
  {
    if (!needed[jump_nodes[jump]])
      continue;
    const Node &node = nodes[jump_nodes[jump]];
    const SteppedFunction *const function =
        node.kind == Kind::stepped ? &stepped_functions()[node.number]
                                   : nullptr;
    const auto level = level_inside(
        arguments[jump].value, function != nullptr ? function->first_step : 0.,
        function != nullptr ? function->period : 0.);
    if (!level)
      continue;
    const double scale =
        magnitude(node_bounds[node.operand[0]].value) +
        (function != nullptr ? std::abs(*level)
                             : magnitude(node_bounds[node.operand[1]].value));
    crossings.push_back(
        {jump, *level, arguments[jump] - Bounds{*level, {}}, scale});
  }
  return node_bounds.back();
}

unsigned int Formula::n_jumps() const
{
  return jump_nodes.size();
}
} // namespace Voussoir
