// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_variables_h
#define voussoir_run_variables_h

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/** The section of the numbers that other entries use by their names. */
inline const std::string variables_section = "Variables";

/**
 * Numbers with names. In the value of any entry $name stands for one of them,
 * $(expression) for an Expression of them, and $$ for a dollar sign; another
 * dollar sign is one.
 */
class Variables
{
public:
  /**
   * Take a variable, or another value of one, which keeps its place.
   *
   * @param expression of those before it, as all the variables are in order.
   * @throws InputError if the name is none, or the name of a function.
   */
  void set(const std::string &name, const std::string &expression);

  /**
   * Find the values.
   *
   * @throws InputError if an expression is not valid, uses a variable that is
   *   not before its own, or is not a number.
   */
  void evaluate();

  /** True if there are none. */
  bool empty() const { return expressions.empty(); }
  /** "x = 2, h = 1.5". */
  std::string values_in_words() const;
  /** The names that nothing uses so far, in their order. */
  std::vector<std::string> unused() const;

  /**
   * The text with numbers in the places of the variables: in parentheses where
   * a sign follows an operator or is followed by ^.
   *
   * @param place of it, with which a message begins.
   * @throws InputError if there is no such variable, or an expression is not
   *   valid or not a number.
   */
  std::string in(const std::string &text, const std::string &place);

private:
  /** The names of the first @p n. */
  std::vector<std::string> names(std::size_t n) const;
  void use(const std::string &expression);
  std::string
  number_at(const std::string &text, std::size_t &k, const std::string &place);
  double value_of(const std::string &expression, const std::string &place);

  std::vector<std::pair<std::string, std::string>> expressions;
  std::vector<double> values;
  std::set<std::string> used;
};

/**
 * A text with @p number in the place of what begins at @p begin and ends at
 * @p end: in parentheses if it has a sign and stands behind an operator or in
 * front of ^.
 */
std::string with_number(const std::string &text,
                        std::size_t begin,
                        std::size_t end,
                        const std::string &number);
} // namespace Voussoir

#endif
