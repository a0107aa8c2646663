// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/nearest_name.h>
#include <voussoir/output/summary/text_lines.h>
#include <voussoir/run/sweep/sweep_results.h>
#include <voussoir/run/sweep/sweep_values.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <vector>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

/** The letters of a misspelt name that are likely to be slips. */
constexpr unsigned int most_slips = 2;

Json::json_pointer place_of(const std::string &result)
{
  Json::json_pointer place;
  for (const std::string &name :
       dealii::Utilities::split_string_list(result, '/'))
    place /= name;
  return place;
}

std::string in_quotes(const std::vector<std::string> &names)
{
  std::string words;
  for (const std::string &name : names)
    words += (words.empty() ? "'" : ", '") + name + '\'';
  return words;
}

std::string without_digits(std::string text)
{
  text.erase(std::remove_if(text.begin(), text.end(),
                            [](const unsigned char letter) {
                              return std::isdigit(letter);
                            }),
             text.end());
  return text;
}
} // namespace

bool has_result(const Json &summary, const std::string &result)
{
  return summary.contains(place_of(result));
}

std::string result_at(const Json &summary, const std::string &result)
{
  if (!has_result(summary, result))
    return {};
  const Json &value = summary.at(place_of(result));
  if (value.is_null())
    return {};
  if (value.is_number_float())
    return value_text(value.get<double>());
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::optional<double> number_at(const Json &summary, const std::string &result)
{
  if (!has_result(summary, result))
    return {};
  const Json &value = summary.at(place_of(result));
  return value.is_number() ? std::optional<double>(value.get<double>())
                           : std::nullopt;
}

void add_results(const Json &summary, std::set<std::string> &results)
{
  if (!summary.is_object()) // that of a run without an answer
    return;
  const Json flat = summary.flatten();
  for (const auto &[place, value] : flat.items())
    results.insert(place.substr(1));
}

std::string misspelt_for(const std::string &result,
                         const std::set<std::string> &known)
{
  std::vector<std::string> meant;
  for (const std::string &name : known)
    if (without_digits(name) != without_digits(result) &&
        edit_distance(name, result) <= most_slips)
      meant.push_back(name);
  return in_quotes(meant);
}

std::string unknown_result(const std::string &result,
                           const std::set<std::string> &known)
{
  const std::vector<std::string> names(known.begin(), known.end());
  std::vector<std::string> nearest = nearest_texts(result, names);
  if (nearest.empty())
    nearest = nearest_names(result.substr(result.rfind('/') + 1), names);
  if (!nearest.empty())
    return "--result '" + result +
           "' is in the summary of no run; the nearest: " + in_quotes(nearest) +
           '.';
  std::set<std::string> first;
  for (const std::string &name : names)
    first.insert(name.substr(0, name.find('/')));
  return "--result '" + result +
         "' is in the summary of no run; give a name that begins with one of " +
         in_quotes({first.begin(), first.end()}) + '.';
}
} // namespace Voussoir
