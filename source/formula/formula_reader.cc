// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/formula/formula_reader.h>

#include <deal.II/base/exceptions.h>

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Voussoir
{
namespace
{
// Functions that muParser calls, known in the byte code by their addresses.
constexpr auto negative = [](double a) { return -a; };
constexpr auto itself = [](double a) { return a; };
constexpr auto angle = [](double y, double x) { return std::atan2(y, x); };
constexpr auto power = [](double a, double b) { return std::pow(a, b); };
constexpr auto choose = [](double condition, double a, double b) {
  return condition != 0. ? a : b;
};
constexpr auto sum = [](const double *a, int n) {
  return std::accumulate(a, a + n, 0.);
};
constexpr auto average = [](const double *a, int n) { return sum(a, n) / n; };
// From the last one on, as Formula does: with a NaN the order matters.
double minimum(const double *a, int n)
{
  return n == 1 ? a[0] : std::min(a[0], minimum(a + 1, n - 1));
}
double maximum(const double *a, int n)
{
  return n == 1 ? a[0] : std::max(a[0], maximum(a + 1, n - 1));
}
} // namespace

/** Makes a formula by going through its byte code with a stack. */
class FormulaReader
{
public:
  explicit FormulaReader(const std::vector<double> &variables)
      : variables(variables)
  {}

  Formula read(const mu::ParserByteCode &code)
  {
    for (std::size_t k = 0; k < code.GetSize(); ++k)
      read(code.GetBase()[k]);
    AssertDimension(stack.size(), 1);
    const std::size_t n = formula.nodes.size();
    formula.node_values.resize(n);
    formula.node_bounds.resize(n);
    formula.needed.resize(n);
    formula.arguments.resize(formula.n_jumps());
    return formula;
  }

private:
  using Kind = Formula::Kind;

  void read(const mu::SToken &token)
  {
    switch (token.Cmd)
    {
    case mu::cmLE: return push(Kind::less_equal);
    case mu::cmGE: return push(Kind::greater_equal);
    case mu::cmNEQ: return push(Kind::not_equal);
    case mu::cmEQ: return push(Kind::equal);
    case mu::cmLT: return push(Kind::less);
    case mu::cmGT: return push(Kind::greater);
    case mu::cmADD: return push(Kind::add);
    case mu::cmSUB: return push(Kind::subtract);
    case mu::cmMUL: return push(Kind::multiply);
    case mu::cmDIV: return push(Kind::divide);
    case mu::cmPOW: return push(Kind::power);
    case mu::cmLAND: return push(Kind::both);
    case mu::cmLOR: return push(Kind::any);
    case mu::cmENDIF: return push(Kind::choose);
    case mu::cmVAL: return push(Kind::constant, invalid_index, token.Val.data2);
    case mu::cmVAR:
    case mu::cmVARMUL:
    case mu::cmVARPOW2:
    case mu::cmVARPOW3:
    case mu::cmVARPOW4: return read_variable(token);
    case mu::cmFUNC: return read_function(token);
    case mu::cmIF: // both branches follow, and leave an operand each
    case mu::cmELSE:
    case mu::cmEND: return;
    default:
      AssertThrow(false, dealii::ExcMessage("unknown byte code of a formula"));
    }
  }

  void read_variable(const mu::SToken &token)
  {
    push(Kind::variable, token.Val.ptr - variables.data());
    if (token.Cmd == mu::cmVARMUL)
    {
      push(Kind::constant, invalid_index, token.Val.data);
      push(Kind::multiply);
      push(Kind::constant, invalid_index, token.Val.data2);
      push(Kind::add);
    }
    else if (token.Cmd != mu::cmVAR)
    {
      push(Kind::constant, invalid_index, 2. + (token.Cmd - mu::cmVARPOW2));
      push(Kind::power);
    }
  }

  void read_function(const mu::SToken &token)
  {
    const auto is = [&](const auto function) {
      return token.Fun.cb._pRawFun ==
             reinterpret_cast<mu::erased_fun_type>(function);
    };
    const unsigned int n_arguments = std::abs(token.Fun.argc);
    if (is(+itself))
      return;
    if (is(+negative))
      return push(Kind::negative);
    if (is(+angle))
      return push(Kind::angle);
    if (is(+power))
      return push(Kind::power);
    if (is(+choose))
      return push(Kind::choose);
    if (is(&minimum))
      return fold(Kind::minimum, n_arguments);
    if (is(&maximum))
      return fold(Kind::maximum, n_arguments);
    if (is(+sum))
      return fold(Kind::add, n_arguments);
    if (is(+average))
    {
      fold(Kind::add, n_arguments);
      push(Kind::constant, invalid_index, n_arguments);
      return push(Kind::divide);
    }
    for (unsigned int i = 0; i < smooth_functions().size(); ++i)
      if (is(smooth_functions()[i].value))
        return push(Kind::smooth, i);
    for (unsigned int i = 0; i < stepped_functions().size(); ++i)
      if (is(stepped_functions()[i].value))
        return push(Kind::stepped, i);
    AssertThrow(false, dealii::ExcMessage("unknown function of a formula"));
  }

  /** Combine the last @p n operands, from the first on. */
  void fold(const Kind kind, const unsigned int n)
  {
    // a, b, c on the stack become a o (b o c): the operands of a node are the
    // last ones that were pushed.
    for (unsigned int k = 1; k < n; ++k)
      push(kind);
  }

  void push(const Kind kind,
            const unsigned int number = invalid_index,
            const double constant = 0.)
  {
    const unsigned int n_operands = Formula::n_operands(kind);
    const unsigned int here = formula.nodes.size();
    Formula::Node node = {kind,   {{0, 0, 0}}, constant,
                          number, here,        invalid_index};
    for (unsigned int k = n_operands; k-- > 0;)
    {
      node.operand[k] = stack.back();
      stack.pop_back();
    }
    if (n_operands > 0)
      node.first = formula.nodes[node.operand[0]].first;
    if (Formula::has_jump(kind))
    {
      node.jump = formula.jump_nodes.size();
      formula.jump_nodes.push_back(here);
    }
    formula.nodes.push_back(node);
    stack.push_back(here);
  }

  Formula formula;
  const std::vector<double> &variables;
  std::vector<unsigned int> stack;
};

void define_functions(mu::Parser &parser)
{
  parser.ClearFun();
  parser.ClearInfixOprt();
  parser.DefineInfixOprt("-", +negative);
  parser.DefineInfixOprt("+", +itself);
  for (const SmoothFunction &function : smooth_functions())
    parser.DefineFun(function.name, function.value);
  for (const SteppedFunction &function : stepped_functions())
    parser.DefineFun(function.name, function.value);
  parser.DefineFun("atan2", +angle);
  parser.DefineFun("pow", +power);
  parser.DefineFun("if", +choose);
  parser.DefineFun("min", &minimum);
  parser.DefineFun("max", &maximum);
  parser.DefineFun("sum", +sum);
  parser.DefineFun("avg", +average);
}

Formula read_formula(const mu::Parser &parser,
                     const std::vector<double> &variables)
{
  return FormulaReader(variables).read(parser.GetByteCode());
}
} // namespace Voussoir
