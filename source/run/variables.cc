// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/formula/expression.h>
#include <voussoir/output/summary/text_lines.h>
#include <voussoir/run/variables.h>

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>

namespace Voussoir
{
namespace
{
/** The largest number that is written as an integer if it is one. */
constexpr double largest_integer = 1e15;

bool begins_name(const char letter)
{
  return std::isalpha(static_cast<unsigned char>(letter)) != 0 || letter == '_';
}

/** The end of the word that begins at @p k. */
std::size_t end_of_word(const std::string &text, std::size_t k)
{
  while (k < text.size() &&
         (begins_name(text[k]) ||
          std::isdigit(static_cast<unsigned char>(text[k])) != 0))
    ++k;
  return k;
}

bool is_word(const std::string &name)
{
  return !name.empty() && begins_name(name[0]) &&
         end_of_word(name, 0) == name.size();
}

/** Behind the parenthesis that closes the one at @p k; npos: it is open. */
std::size_t end_of_parentheses(const std::string &text, std::size_t k)
{
  unsigned int depth = 0;
  for (; k < text.size(); ++k)
    if (text[k] == '(')
      ++depth;
    else if (text[k] == ')' && --depth == 0)
      return k + 1;
  return std::string::npos;
}

/** As entries for integers and for numbers read it. */
std::string text_for_entries(const double value)
{
  return value == std::floor(value) && std::abs(value) < largest_integer
             ? std::to_string(static_cast<std::int64_t>(value))
             : value_text(value);
}
} // namespace

std::string with_number(const std::string &text,
                        const std::size_t begin,
                        const std::size_t end,
                        const std::string &number)
{
  const std::string blanks = " \t";
  const std::size_t before =
      begin == 0 ? std::string::npos : text.find_last_not_of(blanks, begin - 1);
  const std::size_t behind = text.find_first_not_of(blanks, end);
  const bool has_sign = number.front() == '-' || number.front() == '+';
  const bool is_operand =
      (before != std::string::npos &&
       std::string("+-*/^").find(text[before]) != std::string::npos) ||
      (behind != std::string::npos && text[behind] == '^');
  return text.substr(0, begin) +
         (has_sign && is_operand ? '(' + number + ')' : number) +
         text.substr(end);
}

void Variables::set(const std::string &name, const std::string &expression)
{
  if (!is_word(name) || is_function_or_constant(name))
    throw InputError("The variable '" + name + "' in '" + variables_section +
                     "' has a name that cannot stand in an expression; take "
                     "one word of letters, digits and _ that begins with a "
                     "letter and is no function or constant.");
  const auto known =
      std::find_if(expressions.begin(), expressions.end(),
                   [&](const auto &other) { return other.first == name; });
  if (known != expressions.end())
    known->second = expression;
  else
    expressions.emplace_back(name, expression);
}

void Variables::evaluate()
{
  used.clear();
  values.clear();
  for (const auto &[name, expression] : expressions)
  {
    const std::string parameter = variables_section + '/' + name;
    const double value =
        Expression(expression, names(values.size()), parameter)(values);
    if (!std::isfinite(value))
      throw InputError("The parameter '" + parameter + "' is '" + expression +
                       "', which is no finite number; change it, or what it "
                       "is made from.");
    values.push_back(value);
  }
}

std::vector<std::string> Variables::names(const std::size_t n) const
{
  std::vector<std::string> names;
  for (std::size_t k = 0; k < n; ++k)
    names.push_back(expressions[k].first);
  return names;
}

std::string Variables::values_in_words() const
{
  std::vector<std::string> words;
  for (std::size_t k = 0; k < values.size(); ++k)
    words.push_back(expressions[k].first + " = " + text_for_entries(values[k]));
  return boost::algorithm::join(words, ", ");
}

std::vector<std::string> Variables::unused() const
{
  std::vector<std::string> unused;
  for (const auto &[name, expression] : expressions)
    if (used.count(name) == 0)
      unused.push_back(name);
  return unused;
}

/** Note that the variables in an expression are used, and those in theirs. */
void Variables::use(const std::string &expression)
{
  for (std::size_t k = 0; k < expression.size();)
  {
    const std::size_t end = end_of_word(expression, k);
    const std::string word = expression.substr(k, end - k);
    k = std::max(end, k + 1);
    for (const auto &[name, of_name] : expressions)
      if (name == word && used.insert(name).second)
        use(of_name);
  }
}

double Variables::value_of(const std::string &expression,
                           const std::string &place)
{
  use(expression);
  try
  {
    return Expression(expression, names(values.size()),
                      "$(" + expression + ')')(values);
  }
  catch (const InputError &error)
  {
    throw InputError(place + ": " + error.what());
  }
}

/** What stands for the dollar sign at @p k, of which the end is set. */
std::string Variables::number_at(const std::string &text,
                                 std::size_t &k,
                                 const std::string &place)
{
  const std::size_t begin = k + 1;
  const char next = begin < text.size() ? text[begin] : '\0';
  if (next == '(')
  {
    k = end_of_parentheses(text, begin);
    if (k == std::string::npos)
      throw InputError(place + ": '" + text.substr(begin - 1) +
                       "' has a parenthesis that is not closed on its line.");
    const std::string expression = text.substr(begin + 1, k - begin - 2);
    const double value = value_of(expression, place);
    if (!std::isfinite(value))
      throw InputError(place + ": '$(" + expression +
                       ")' is no finite number; change it, or what it is made "
                       "from.");
    return text_for_entries(value);
  }
  k = end_of_word(text, begin);
  const std::string name = text.substr(begin, k - begin);
  for (std::size_t n = 0; n < values.size(); ++n)
    if (expressions[n].first == name)
    {
      use(name);
      return text_for_entries(values[n]);
    }
  throw InputError(place + ": there is no variable '" + name + "' in '" +
                   variables_section + "'; " +
                   (empty() ? "there are none"
                            : "those are " + boost::algorithm::join(
                                                 names(values.size()), ", ")) +
                   ". Write $$ for a dollar sign.");
}

std::string Variables::in(const std::string &text, const std::string &place)
{
  std::string result = text;
  for (std::size_t k = 0; (k = result.find('$', k)) != std::string::npos;)
  {
    const char next = k + 1 < result.size() ? result[k + 1] : '\0';
    if (next == '$')
      result.erase(k++, 1);
    else if (next == '(' || begins_name(next))
    {
      std::size_t end = k;
      const std::string number = number_at(result, end, place);
      const std::size_t n_behind = result.size() - end;
      result = with_number(result, k, end, number);
      k = result.size() - n_behind;
    }
    else
      ++k;
  }
  return result;
}
} // namespace Voussoir
