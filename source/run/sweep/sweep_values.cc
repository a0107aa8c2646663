// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/run/sweep/sweep_values.h>
#include <voussoir/run/variables.h>

#include <deal.II/base/utilities.h>

#include <boost/lexical_cast/try_lexical_convert.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::Utilities::split_string_list;

/** More runs than anybody wants are a slip of the pen. */
constexpr unsigned int most_values = 100000;

const std::string forms_of_sweep =
    "give NAME=START:END:NUMBER, NAME=START:END:NUMBER:log or NAME=A | B | C, "
    "such as \"Friction/Strength=0.1:1:20\".";

const std::string forms_of_search =
    "give NAME=LOW:HIGH or NAME=LOW:HIGH:WIDTH, such as "
    "\"Friction/Strength=0:1:1e-6\".";

// Words are not looked for by std::regex, which takes a stack as deep as a text
// is long; a text may list as many numbers as there are joints.

bool is_of_word(const char letter)
{
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
}

bool is_space(const char letter)
{
  return std::isspace(static_cast<unsigned char>(letter)) != 0;
}

/** Where @p variable is a word of a text, from @p begin on; npos: nowhere. */
std::size_t find_word(const std::string &text,
                      const std::string &variable,
                      const std::size_t begin)
{
  std::size_t k = text.find(variable, begin);
  for (; k != text.npos; k = text.find(variable, k + 1))
  {
    const std::size_t end = k + variable.size();
    if ((k == 0 || !is_of_word(text[k - 1])) &&
        (end == text.size() || !is_of_word(text[end])))
      break;
  }
  return k;
}

/** The parts of "TEXT for VARIABLE=VALUES". */
struct TextAndVariable
{
  std::string text, variable, values;
};

/** What stands from the last " for VARIABLE=" on is its values. */
std::optional<TextAndVariable> text_and_variable(const std::string &all)
{
  const std::string separator = "for";
  for (std::size_t k = all.rfind(separator); k != all.npos && k > 0;
       k = all.rfind(separator, k - 1))
  {
    const auto at = all.begin() + k + separator.size();
    const auto begin = std::find_if_not(at, all.end(), is_space);
    const auto end = std::find_if_not(begin, all.end(), is_of_word);
    const auto equals = std::find_if_not(end, all.end(), is_space);
    if (is_space(all[k - 1]) && begin != at && end != begin &&
        equals != all.end() && *equals == '=')
    {
      const std::string text = dealii::Utilities::trim(all.substr(0, k));
      if (!text.empty())
        return TextAndVariable{text, {begin, end}, {equals + 1, all.end()}};
    }
  }
  return {};
}

/** A number that people read: 2.2, and not 2.1999999999999997. */
std::string short_number(const double number, const double range)
{
  constexpr double rounding = 1e-14;
  return std::abs(number) <= rounding * std::abs(range) ? "0"
                                                        : text_to_copy(number);
}

struct NameAndValues
{
  NameAndValues(const std::string &option,
                const std::string &text,
                const std::string &forms)
  {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos || equals + 1 == text.size())
      throw InputError(option + " '" + text +
                       "' must have a parameter and its values: " + forms);
    of.entry = dealii::Utilities::trim(text.substr(0, equals));
    values = text.substr(equals + 1);
    if (const auto parts = text_and_variable(values))
    {
      of.text = parts->text;
      of.variable = parts->variable;
      values = parts->values;
      if (find_word(of.text, of.variable, 0) == of.text.npos)
        throw InputError(option + " '" + text + "' has values of '" +
                         of.variable + "', which must be a word of '" +
                         of.text +
                         "', as in \"Loads/Body force=sin(a); -cos(a) for "
                         "a=0:0.5:6\".");
    }
  }

  ChangingEntry of;
  std::string values;
};

/**
 * The values of a list, or none: between "||", if values have "|" in them, or
 * between "|". One value alone is a list, too.
 */
std::vector<std::string> list_in(const std::string &values)
{
  for (const std::string bar : {"||", "|"})
    if (values.find(bar) != values.npos)
      return split_string_list(values, bar);
  return values.find(':') == values.npos ? split_string_list(values, '|')
                                         : std::vector<std::string>();
}

/** The finite numbers between colons, or none of them. */
std::vector<double> numbers(const std::vector<std::string> &words)
{
  std::vector<double> read(words.size());
  for (std::size_t i = 0; i < words.size(); ++i)
    if (!boost::conversion::try_lexical_convert(words[i], read[i]) ||
        !std::isfinite(read[i]))
      return {};
  return read;
}
} // namespace

std::string ChangingEntry::assignment(const std::string &value) const
{
  if (text.empty())
    return entry + '=' + value;
  std::string with_value = text;
  for (std::size_t k = 0;
       (k = find_word(with_value, variable, k)) != with_value.npos;)
  {
    const std::size_t end = k + variable.size();
    const std::size_t n_behind = with_value.size() - end;
    with_value = with_number(with_value, k, end, value);
    k = with_value.size() - n_behind;
  }
  return entry + '=' + with_value;
}

SweepAxis read_sweep_axis(const std::string &text)
{
  const NameAndValues given("--sweep", text, forms_of_sweep);
  if (std::vector<std::string> list = list_in(given.values); !list.empty())
    return {given.of, std::move(list)};
  std::vector<std::string> words = split_string_list(given.values, ':');
  const bool by_ratio = words.size() == 4 && words.back() == "log";
  if (by_ratio)
    words.pop_back();
  const std::vector<double> of = numbers(words);
  if (of.size() != 3 || of[2] < 2. || of[2] > most_values ||
      of[2] != std::floor(of[2]) || (by_ratio && !(of[0] * of[1] > 0.)))
    throw InputError("--sweep '" + text +
                     "' cannot be read; there must be 2 to 100000 values, for "
                     "'log' of one sign: " +
                     forms_of_sweep);
  const unsigned int n = of[2];
  SweepAxis axis = {given.of, {}};
  for (unsigned int k = 0; k < n; ++k)
  {
    const double share = double(k) / (n - 1);
    // Ends are as given.
    axis.values.push_back(
        k == 0       ? words[0]
        : k == n - 1 ? words[1]
        : by_ratio
            ? short_number(of[0] * std::pow(of[1] / of[0], share), 0.)
            : short_number(of[0] + share * (of[1] - of[0]), of[1] - of[0]));
  }
  return axis;
}

std::vector<std::vector<std::string>>
points_of(const std::vector<SweepAxis> &axes)
{
  double n_points = 1.;
  for (const SweepAxis &axis : axes)
    n_points *= axis.values.size();
  if (n_points > most_values)
    throw InputError(Voussoir::text("The values of all --sweep together make ",
                                    n_points, " runs, and ", most_values,
                                    " are the most; give fewer values."));
  std::vector<std::vector<std::string>> points(1);
  for (const SweepAxis &axis : axes)
  {
    std::vector<std::vector<std::string>> more;
    for (const auto &point : points)
      for (const std::string &value : axis.values)
      {
        more.push_back(point);
        more.back().push_back(value);
      }
    points = std::move(more);
  }
  return points;
}

SearchRange read_search_range(const std::string &text)
{
  const NameAndValues given("--find", text, forms_of_search);
  const std::vector<double> of = numbers(split_string_list(given.values, ':'));
  if (of.size() < 2 || of.size() > 3 || !(of[0] < of[1]) ||
      (of.size() == 3 && !(of[2] > 0. && of[2] < 1.)))
    throw InputError("--find '" + text +
                     "' cannot be read; LOW must be less than HIGH, and WIDTH "
                     "between 0 and 1: " +
                     forms_of_search);
  SearchRange range = {given.of, of[0], of[1]};
  if (of.size() == 3)
    range.width = of[2];
  return range;
}
} // namespace Voussoir
