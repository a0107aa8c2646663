// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/formula/formula.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
unsigned int Formula::n_operands(const Kind kind)
{
  switch (kind)
  {
  case Kind::constant:
  case Kind::variable: return 0;
  case Kind::negative:
  case Kind::smooth:
  case Kind::stepped: return 1;
  case Kind::choose: return 3;
  default: return 2;
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
  case Kind::angle: return true;
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
  case Kind::variable: return node.constant;
  case Kind::negative: return -a;
  case Kind::add: return a + b;
  case Kind::subtract: return a - b;
  case Kind::multiply: return a * b;
  case Kind::divide: return a / b;
  case Kind::power: return std::pow(a, b);
  case Kind::less: return a < b;
  case Kind::less_equal: return a <= b;
  case Kind::greater: return a > b;
  case Kind::greater_equal: return a >= b;
  case Kind::equal: return a == b;
  case Kind::not_equal: return a != b;
  case Kind::both: return a != 0. && b != 0.;
  case Kind::any: return a != 0. || b != 0.;
  case Kind::choose: return a != 0. ? b : c;
  case Kind::smooth: return smooth_functions()[node.number].value(a);
  case Kind::stepped: return stepped_functions()[node.number].value(a);
  case Kind::minimum: return std::min(a, b);
  case Kind::maximum: return std::max(a, b);
  case Kind::angle: return std::atan2(a, b);
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

double Formula::argument(const unsigned int jump,
                         const std::vector<double> &values) const
{
  const Node &node = nodes[jump_nodes[jump]];
  evaluate(node.first, jump_nodes[jump], values);
  return argument_of(node);
}
} // namespace Voussoir
