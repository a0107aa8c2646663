// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/report/curves_plot.h>
#include <voussoir/run/sweep/sweep_layout.h>

#include <boost/lexical_cast/try_lexical_convert.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace Voussoir
{
namespace
{
/** Two entries with more numbers than this each are drawn as a map. */
constexpr std::size_t most_numbers_as_curves = 6;

/** The digits of a number in a sentence, and the letters that need no such. */
constexpr int digits_in_sentence = 4;
constexpr std::size_t letters_as_given = 6;

/** The values of an entry, of which numbers are put in order. */
SweptEntry swept_entry(const std::string &name,
                       const std::size_t k,
                       const std::vector<SweepRun> &runs)
{
  SweptEntry entry = {name, {}, {}};
  std::set<std::string> known;
  bool are_numbers = true;
  std::vector<double> numbers;
  for (const SweepRun &run : runs)
    if (known.insert(run.values[k]).second)
    {
      entry.values.push_back(run.values[k]);
      double number = 0.;
      are_numbers =
          are_numbers &&
          boost::conversion::try_lexical_convert(run.values[k], number) &&
          std::isfinite(number);
      numbers.push_back(number);
    }
  if (!are_numbers)
    return entry;
  std::vector<std::size_t> order(numbers.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](const std::size_t a, const std::size_t b) {
                     return numbers[a] < numbers[b];
                   });
  const std::vector<std::string> values = entry.values;
  for (std::size_t n = 0; n < order.size(); ++n)
  {
    entry.values[n] = values[order[n]];
    entry.numbers.push_back(numbers[order[n]]);
  }
  return entry;
}

/** The number of the entry along x: of equal ones the last. */
std::size_t entry_along(const std::vector<SweptEntry> &entries)
{
  const auto comes_before = [](const SweptEntry &a, const SweptEntry &b) {
    const bool a_varies = a.numbers.size() > 1, b_varies = b.numbers.size() > 1;
    return a_varies != b_varies ? b_varies : a.values.size() <= b.values.size();
  };
  std::size_t along = 0;
  for (std::size_t k = 1; k < entries.size(); ++k)
    if (comes_before(entries[along], entries[k]))
      along = k;
  return along;
}

bool is_map(const SweptEntry &along, const std::vector<SweptEntry> &others)
{
  return others.size() == 1 &&
         std::min(along.numbers.size(), others[0].numbers.size()) >
             most_numbers_as_curves;
}
} // namespace

bool SweptEntry::is_by_ratio() const
{
  const std::size_t n = numbers.size();
  if (n < 3 || numbers.front() <= 0.)
    return false;
  const double middle = numbers[n / 2], share = double(n / 2) / (n - 1);
  const double first = numbers.front(), last = numbers.back();
  return std::abs(middle - first * std::pow(last / first, share)) <
         std::abs(middle - (first + share * (last - first)));
}

SweepLayout layout_of(const std::vector<std::string> &names,
                      const std::vector<SweepRun> &runs)
{
  std::vector<SweptEntry> entries;
  for (std::size_t k = 0; k < names.size(); ++k)
    entries.push_back(swept_entry(names[k], k, runs));
  const std::size_t along = entry_along(entries);
  const std::vector<std::string> in_short = short_names(names);

  SweepLayout layout;
  layout.along = entries[along];
  std::vector<std::size_t> of_curve;
  std::vector<SweptEntry> others;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (k != along && entries[k].values.size() > 1)
    {
      of_curve.push_back(k);
      others.push_back(entries[k]);
      layout.others.push_back(names[k]);
    }
  std::map<std::string, std::size_t> place;
  for (std::size_t n = 0; n < layout.along.values.size(); ++n)
    place[layout.along.values[n]] = n;
  std::map<std::vector<std::string>, std::size_t> curve_of;
  if (is_map(layout.along, others))
  {
    layout.form = SweepLayout::Form::map;
    layout.across = others[0];
    // Rows in the order of the numbers, not of the runs.
    for (const std::string &value : layout.across.values)
      curve_of.emplace(std::vector<std::string>{value}, curve_of.size());
    layout.labels.resize(curve_of.size());
    layout.runs.resize(curve_of.size());
  }
  for (std::size_t k = 0; k < runs.size(); ++k)
  {
    std::vector<std::string> values, its_names;
    for (const std::size_t n : of_curve)
    {
      values.push_back(runs[k].values[n]);
      its_names.push_back(in_short[n]);
    }
    const auto [found, is_new] = curve_of.emplace(values, curve_of.size());
    const std::size_t curve = found->second;
    if (is_new)
    {
      layout.labels.emplace_back();
      layout.runs.emplace_back();
    }
    if (layout.runs[curve].empty())
    {
      layout.labels[curve] = short_words_of(its_names, values);
      layout.runs[curve].resize(layout.along.values.size(),
                                SweepLayout::no_run);
    }
    std::size_t &run = layout.runs[curve][place.at(runs[k].values[along])];
    if (run == SweepLayout::no_run) // a value that is given twice
      run = k;
  }
  if (layout.form == SweepLayout::Form::curves &&
      layout.runs.size() > most_curves_in_plot)
    layout.form = SweepLayout::Form::table;
  return layout;
}

std::vector<std::string> short_names(const std::vector<std::string> &names)
{
  std::vector<std::string> last;
  for (const std::string &name : names)
    last.push_back(name.substr(name.rfind('/') + 1));
  for (const std::string &name : last)
    if (std::count(last.begin(), last.end(), name) > 1)
      return names;
  return last;
}

std::string short_value(const std::string &value)
{
  double number = 0.;
  if (value.size() <= letters_as_given ||
      !boost::conversion::try_lexical_convert(value, number))
    return value;
  return text_with_digits(number, digits_in_sentence);
}

std::string short_words_of(const std::vector<std::string> &names,
                           const std::vector<std::string> &values)
{
  std::vector<std::string> in_short;
  for (const std::string &value : values)
    in_short.push_back(short_value(value));
  return words_of(names, in_short);
}
} // namespace Voussoir
