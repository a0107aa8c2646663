// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/pattern_description.h>

#include <deal.II/base/utilities.h>

#include <boost/algorithm/string/join.hpp>

#include <regex>
#include <set>

namespace Voussoir
{
namespace
{
using Kind = PatternDescription::Kind;

/** A bound, unless it is that of a type. */
std::optional<std::string> bound_of_text(const std::string &text)
{
  static const std::set<std::string> limits = {
      "-MAX_DOUBLE", "MAX_DOUBLE", "-2147483648", "2147483647", "4294967295"};
  if (limits.count(text) > 0)
    return {};
  return text;
}

/** "a number from LOW to HIGH", without the bounds that are none. */
std::string text_of_range(const std::string &number,
                          const PatternDescription &of)
{
  if (of.low && of.high)
    return number + " from " + *of.low + " to " + *of.high;
  if (of.low)
    return number + ", at least " + *of.low;
  return of.high ? number + ", at most " + *of.high : number;
}

std::string text_of_list(const PatternDescription &of)
{
  std::string values = "values";
  if (of.low == of.high && of.low)
    values = *of.low + " values";
  else if (of.high)
    values = of.low.value_or("0") + " to " + *of.high + " values";
  else if (of.low && of.low != "0")
    values = "at least " + *of.low + " values";
  const std::string element = text_of_pattern(of.element);
  return values + " separated by '" + of.separator + "'" +
         (element == "any text" ? "" : ", each " + element);
}
} // namespace

PatternDescription read_pattern(const std::string &text)
{
  const std::string description = text.substr(0, text.rfind(']') + 1);
  std::smatch found;
  const auto is = [&](const char *pattern) {
    return std::regex_match(description, found, std::regex(pattern));
  };
  const auto with_bounds = [&found](const Kind kind, const unsigned int group) {
    PatternDescription of;
    of.kind = kind;
    of.low = bound_of_text(found[group]);
    of.high = bound_of_text(found[group + 1]);
    return of;
  };
  PatternDescription of;
  if (is("\\[Anything\\]"))
    of.kind = Kind::text;
  else if (is("\\[Bool\\]"))
    of.kind = Kind::truth;
  else if (is("\\[Double (\\S+)\\.\\.\\.(\\S+) \\(inclusive\\)\\]"))
    of = with_bounds(Kind::number, 1);
  else if (is("\\[Integer range (\\S+)\\.\\.\\.(\\S+) \\(inclusive\\)\\]"))
    of = with_bounds(Kind::integer, 1);
  else if (is("\\[Selection (.*?) ?\\]"))
  {
    of.kind = Kind::selection;
    of.choices = dealii::Utilities::split_string_list(found[1].str(), '|');
  }
  else if (is("\\[List of <(.*)> of length (\\d+)\\.\\.\\.(\\d+) "
              "\\(inclusive\\)(?: separated by <(.*)>)?\\]"))
  {
    of = with_bounds(Kind::list, 2);
    of.element = found[1];
    of.separator = found[4].matched ? found[4].str() : ",";
  }
  return of;
}

std::string text_of_pattern(const std::string &text)
{
  const PatternDescription of = read_pattern(text);
  switch (of.kind)
  {
  case Kind::text: return "any text";
  case Kind::truth: return "true or false";
  case Kind::number: return text_of_range("a number", of);
  case Kind::integer: return text_of_range("a whole number", of);
  case Kind::selection:
    return "one of '" + boost::algorithm::join(of.choices, "', '") + "'";
  case Kind::list: return text_of_list(of);
  default: return text.substr(0, text.rfind(']') + 1);
  }
}
} // namespace Voussoir
