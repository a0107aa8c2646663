// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_formula_h
#define voussoir_formula_formula_h

#include <voussoir/base/invalid_index.h>
#include <voussoir/formula/functions.h>

#include <array>
#include <optional>
#include <vector>

namespace Voussoir
{
/**
 * A formula as a list of operations, which says what it is between in a box,
 * and where it may jump or have a kink. See read_formula().
 *
 * A *jump* here is an operation whose value has steps or kinks where its
 * *argument* passes one of certain levels: a comparison, in the difference of
 * its sides at zero, min and max alike, abs, sign and the second coordinate of
 * atan2 at zero, floor and ceil at the integers, rint half-way between.
 */
class Formula
{
public:
  /**
   * A jump that values of the variables in some box may meet: its level is
   * strictly inside the bounds of its argument.
   */
  struct Crossing
  {
    /** The number of the jump. */
    unsigned int jump;
    /** Of its argument. */
    double level;
    /** Of the argument less the level. */
    Bounds distance;
    /** The size of what the argument is a difference of. */
    double scale;
  };

  /** The argument of each jump is known to be in an interval. */
  using Limits = std::vector<Interval>;

  /** The number of its jumps. */
  unsigned int n_jumps() const { return jump_nodes.size(); }

  /** The argument of @p jump, for values of the variables. */
  double argument(unsigned int jump, const std::vector<double> &values) const;

  /** The formula itself, for values of the variables. */
  double value(const std::vector<double> &values) const
  {
    evaluate(0, nodes.size(), values);
    return node_values.back();
  }

  /**
   * The bounds of the formula in a box, and the jumps that can be met there.
   *
   * @param variables their bounds in the box.
   * @param middle their values at its centre.
   * @param limits of the arguments of the jumps, n_jumps() intervals.
   * @param crossings take the jumps whose arguments have a level strictly
   *   inside what is possible in the box and within the limits, or, without
   *   limits, are equal to one but for rounding; those that the value there
   * does not depend on are left out.
   */
  Bounds bounds(const std::vector<Bounds> &variables,
                const std::vector<double> &middle,
                const Limits &limits,
                std::vector<Crossing> &crossings) const;

private:
  /** The empty formula is for FormulaReader alone. */
  Formula() = default;

  enum class Kind
  {
    constant,
    variable,
    negative,
    add,
    subtract,
    multiply,
    divide,
    power,
    less,
    less_equal,
    greater,
    greater_equal,
    equal,
    not_equal,
    both,
    any,
    choose,
    smooth,
    stepped,
    minimum,
    maximum,
    angle
  };

  /** One operation; its operands come before it. */
  struct Node
  {
    Kind kind;
    /** The operands, as many as there are. */
    std::array<unsigned int, 3> operand;
    /** Of a constant. */
    double constant;
    /** Of a variable or a function: its number; else none. */
    unsigned int number;
    /** The first node that belongs to it. */
    unsigned int first;
    /** The number of its jump; none if it has no jump. */
    unsigned int jump;
  };

  friend class FormulaReader;

  static unsigned int n_operands(Kind kind);
  static bool has_jump(Kind kind);
  static double apply(const Node &node, double a, double b, double c);
  /** Of the nodes from @p begin to @p end, and what comes before it. */
  void evaluate(unsigned int begin,
                unsigned int end,
                const std::vector<double> &values) const;
  double argument_of(const Node &node) const;
  Bounds argument_bounds(const Node &node, const Interval &limit) const;
  Bounds bounds_of(const Node &node) const;
  double middle_of(const Node &node, const Bounds &bounds) const;
  Bounds bounds_of_jump(const Node &node, const Bounds &argument) const;
  void evaluate_branch(unsigned int i,
                       const Bounds &argument,
                       const std::vector<double> &middle) const;
  void mark_needed() const;
  /** The level of @p jump that was met in the last box, if there is one. */
  std::optional<double> level_of(unsigned int jump,
                                 const Interval &limit) const;
  Crossing crossing(unsigned int jump, double level) const;

  std::vector<Node> nodes;
  /** The node of each jump. */
  std::vector<unsigned int> jump_nodes;
  /** Of each node, in the last box or at the last place. */
  mutable std::vector<double> node_values;
  mutable std::vector<Bounds> node_bounds;
  mutable std::vector<char> needed;
  /** Of each jump, in the last box. */
  mutable std::vector<Bounds> arguments;
};
} // namespace Voussoir

#endif
