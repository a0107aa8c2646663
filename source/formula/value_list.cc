// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/formula/value_list.h>

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <system_error>

namespace Voussoir
{
namespace
{
std::vector<std::string> split(const std::string &value, const char *const at)
{
  std::vector<std::string> parts;
  boost::algorithm::split(parts, value, boost::algorithm::is_any_of(at));
  for (std::string &part : parts)
    boost::algorithm::trim(part);
  return parts;
}

bool begins_list(const std::string &component)
{
  return boost::algorithm::starts_with(component, list_word) &&
         (component.size() == list_word.size() ||
          std::isspace(
              static_cast<unsigned char>(component[list_word.size()])) != 0);
}

/** The number @p word, place @p k of a list from 0 on. */
double number_of(const std::string &word,
                 const unsigned int k,
                 const std::string &parameter)
{
  double number;
  // A plus is none of from_chars().
  const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  const char *const end = word.data() + word.size();
  const auto [rest, error] =
      std::from_chars(word.data() + has_plus, end, number);
  if (error != std::errc() || rest != end)
    throw InputError(text("The parameter '", parameter, "' has '", word,
                          "' where number ", k,
                          " of its list is expected, counted from 0; write "
                          "numbers with commas between, as in \"list 0.5, "
                          "0.6\"."));
  return number;
}
} // namespace

bool is_value_list(const std::string &value)
{
  const std::vector<std::string> components = split(value, ";");
  return std::any_of(components.begin(), components.end(), begins_list);
}

std::vector<double> numbers_of_list(const std::string &value,
                                    const std::string &parameter,
                                    const unsigned int n_elements,
                                    const std::string &element)
{
  const std::string all =
      boost::algorithm::trim_copy(value).substr(list_word.size());
  std::vector<double> numbers;
  if (!all.empty())
    for (const std::string &word : split(all, ","))
      numbers.push_back(number_of(word, numbers.size(), parameter));
  if (numbers.size() != n_elements)
    throw InputError(text("The parameter '", parameter, "' lists ",
                          counted(numbers.size(), "number"), ", but there ",
                          n_elements == 1 ? "is " : "are ",
                          counted(n_elements, element), "; give one for each ",
                          element, ", in the order of their numbers."));
  return numbers;
}

std::vector<std::vector<double>>
vectors_of_lists(const std::string &value,
                 const std::string &parameter,
                 const unsigned int n_components,
                 const unsigned int n_elements,
                 const std::string &element)
{
  const std::vector<std::string> lists = split(value, ";");
  if (lists.size() != n_components)
    throw InputError(text("The parameter '", parameter, "' has ",
                          counted(lists.size(), "list"), "; ", n_components,
                          " are expected, one for each component, with "
                          "semicolons between."));
  if (!std::all_of(lists.begin(), lists.end(), begins_list))
    throw InputError("The parameter '" + parameter +
                     "' has a list for some components only; give one for "
                     "each, or expressions.");
  std::vector<std::vector<double>> components;
  for (const std::string &list : lists)
  {
    components.push_back(numbers_of_list(list, parameter, n_elements, element));
    for (unsigned int k = 0; k < n_elements; ++k)
      if (const double number = components.back()[k]; !std::isfinite(number))
        throw InputError(text("The parameter '", parameter, "' lists ",
                              text_of_number(number), " for ", element, ' ', k,
                              "; a force must be finite."));
  }
  return components;
}
} // namespace Voussoir
