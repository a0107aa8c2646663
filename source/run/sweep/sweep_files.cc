// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/report/colour_scale.h>
#include <voussoir/output/report/plot.h>
#include <voussoir/output/summary/text_lines.h>
#include <voussoir/report_page.h>
#include <voussoir/run/sweep/sweep_files.h>
#include <voussoir/run/sweep/sweep_results.h>
#include <voussoir/run/sweep/sweep_values.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/lexical_cast/try_lexical_convert.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <ostream>
#include <set>

namespace Voussoir
{
namespace
{
/** The columns of every sweep: their names, and where summary.json has them. */
const std::vector<std::pair<std::string, std::string>> columns = {
    {"load_factor", "load_factor/carried"},
    {"load_factor_bound", "load_factor/bound"},
    {"within", "within"},
    {"equilibrium_residual", "certificate/equilibrium_residual"},
    {"admissibility_violation", "certificate/admissibility_violation"},
    {"max_utilisation", "certificate/max_utilisation"},
    {"work_over_dissipation", "mechanism/work_over_dissipation"},
    {"closing_violation", "mechanism/closing_violation"},
    {"iterations", "solver/iterations"}};

/** The columns that have a plot. */
const std::set<std::string> worth_a_plot = {"load_factor", "max_utilisation",
                                            "work_over_dissipation"};

/** A difference of load factors, over the larger, that says nothing. */
constexpr double same_factor = 1e-6;

/** The letters of a number that a page shows as it is. */
constexpr std::size_t most_letters = 8;

/** True if a load factor is less than another by more than proofs differ. */
bool is_less(const double a, const double b)
{
  return b - a > same_factor * std::max(std::abs(a), std::abs(b));
}

/** The text of a table's field, in quotes if need be. */
std::string field(const std::string &text)
{
  if (text.find_first_of(",\"\n") == text.npos)
    return text;
  std::string quoted = "\"";
  for (const char letter : text)
    quoted += letter == '"' ? std::string("\"\"")
                            : std::string(1, letter == '\n' ? ' ' : letter);
  return quoted + '"';
}

/** The numbers of @p path over the only parameter, by its values. */
std::vector<PlotPoint> plotted_points(const std::string &path,
                                      const std::vector<SweepRun> &runs)
{
  std::vector<PlotPoint> points;
  for (const SweepRun &run : runs)
  {
    PlotPoint point;
    if (!boost::conversion::try_lexical_convert(run.values[0], point.x) ||
        !std::isfinite(point.x))
      return {}; // words
    if (boost::conversion::try_lexical_convert(result_at(run.summary, path),
                                               point.y) &&
        std::isfinite(point.y))
    {
      point.kind = run.verdict == Status::Kind::collapse         ? "collapse"
                   : run.verdict == Status::Kind::carried_within ? "within"
                                                                 : "carried";
      points.push_back(point);
    }
  }
  std::stable_sort(
      points.begin(), points.end(),
      [](const PlotPoint &a, const PlotPoint &b) { return a.x < b.x; });
  return points;
}

/** How many runs have a number there that no plot can show. */
std::size_t n_infinite(const std::string &path,
                       const std::vector<SweepRun> &runs)
{
  return std::count_if(runs.begin(), runs.end(), [&](const SweepRun &run) {
    double value;
    return boost::conversion::try_lexical_convert(result_at(run.summary, path),
                                                  value) &&
           !std::isfinite(value);
  });
}

/** True if positive values have much the same ratios. */
bool is_by_ratio(const std::vector<PlotPoint> &points)
{
  const std::size_t n = points.size();
  if (n < 3 || points.front().x <= 0.)
    return false;
  const double middle = points[n / 2].x;
  const double first = points.front().x, last = points.back().x;
  return std::abs(middle - std::sqrt(first * last)) <
         std::abs(middle - 0.5 * (first + last));
}
} // namespace

std::string word_of(const SweepRun &run)
{
  return run.has_answer ? run.summary.at("status").get<std::string>()
                        : "failed";
}

std::string counts_of(const std::vector<SweepRun> &runs)
{
  std::map<std::string, std::size_t> of_word;
  for (const SweepRun &run : runs)
    ++of_word[word_of(run)];
  std::string words;
  for (const auto &[word, n] : of_word)
    words += text(words.empty() ? "" : ", ", n, ' ', word);
  return words;
}

std::optional<ExtremeFactors> extreme_factors(const std::vector<SweepRun> &runs)
{
  std::vector<std::pair<double, std::size_t>> factors;
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (double factor;
        boost::conversion::try_lexical_convert(
            result_at(runs[k].summary, columns[0].second), factor) &&
        std::isfinite(factor))
      factors.emplace_back(factor, k);
  if (factors.empty())
    return {};
  ExtremeFactors extremes = {factors[0], factors[0]};
  for (const auto &factor : factors)
  {
    if (is_less(factor.first, extremes.least.first))
      extremes.least = factor;
    if (is_less(extremes.greatest.first, factor.first))
      extremes.greatest = factor;
  }
  return extremes;
}

std::string SharedWarning::description(const std::vector<std::string> &names,
                                       const std::vector<SweepRun> &all) const
{
  const std::string first = words_of(names, all[runs.front()].values);
  if (runs.size() == 1)
    return "With " + first + ": " + text;
  if (runs.size() == all.size())
    return "In all runs: " + text;
  return Voussoir::text("In ", runs.size(), " of ", all.size(),
                        " runs, the first with ", first, ": ", text);
}

std::vector<SharedWarning> warnings_of(const std::vector<SweepRun> &runs)
{
  std::vector<SharedWarning> warnings;
  std::map<std::string, std::size_t> place;
  for (std::size_t k = 0; k < runs.size(); ++k)
    for (const std::string &text : runs[k].warnings)
    {
      const auto [found, is_new] = place.emplace(text, warnings.size());
      if (is_new)
        warnings.push_back({text, {}});
      std::vector<std::size_t> &of = warnings[found->second].runs;
      if (of.empty() || of.back() != k)
        of.push_back(k);
    }
  return warnings;
}

void write_sweep_csv(std::ostream &out,
                     const std::vector<std::string> &names,
                     const std::vector<std::string> &results,
                     const std::vector<SweepRun> &runs)
{
  for (const std::string &name : names)
    out << field(name) << ',';
  out << "status";
  for (const auto &column : columns)
    out << ',' << column.first;
  for (const std::string &result : results)
    out << ',' << field(result);
  out << ",seconds,message,warnings\n";
  for (const SweepRun &run : runs)
  {
    for (const std::string &value : run.values)
      out << field(value) << ',';
    out << word_of(run);
    for (const auto &column : columns)
      out << ',' << field(result_at(run.summary, column.second));
    for (const std::string &result : results)
      out << ',' << field(result_at(run.summary, result));
    out << ',' << value_text(run.seconds) << ',' << field(run.reason) << ','
        << field(boost::algorithm::join(run.warnings, " ")) << '\n';
  }
}

namespace
{
/** A number with the digits that people read, or a text as it is. */
std::string short_field(const std::string &text)
{
  double number = 0.;
  return html_text(boost::conversion::try_lexical_convert(text, number) &&
                           text.size() > most_letters
                       ? text_of_number(number)
                       : text);
}

/** The status of a run, which leads to its page if it has one. */
void write_status(std::ostream &out, const SweepRun &run)
{
  if (!run.page.empty())
    out << "<a href=\"" << html_text(run.page) << "\">";
  out << word_of(run) << (run.page.empty() ? "" : "</a>");
}

/** All runs as lines of a table, without columns that none has. */
void write_sweep_table(
    std::ostream &out,
    const std::vector<std::string> &names,
    const std::vector<std::pair<std::string, std::string>> &columns,
    const std::vector<SweepRun> &runs)
{
  std::vector<std::pair<std::string, std::string>> shown;
  std::copy_if(columns.begin(), columns.end(), std::back_inserter(shown),
               [&](const auto &column) {
                 return std::any_of(
                     runs.begin(), runs.end(), [&](const SweepRun &run) {
                       return !result_at(run.summary, column.second).empty();
                     });
               });
  out << "<div class=\"scrolls\"><table>\n<tr>";
  for (const std::string &name : names)
    out << "<th>" << html_text(name) << "</th>";
  out << "<th>status</th>";
  for (const auto &column : shown)
    out << "<th>" << html_text(column.first) << "</th>";
  out << "</tr>\n";
  for (const SweepRun &run : runs)
  {
    out << "<tr>";
    for (const std::string &value : run.values)
      out << "<td>" << short_field(value) << "</td>";
    out << "<td>";
    write_status(out, run);
    out << "</td>";
    for (const auto &column : shown)
      out << "<td>" << short_field(result_at(run.summary, column.second))
          << "</td>";
    out << "</tr>\n";
  }
  out << "</table></div>\n<p>The numbers have all digits in " << sweep_csv
      << ".</p>\n";
}
} // namespace

void write_sweep_html(std::ostream &out,
                      const std::string &title,
                      const std::vector<std::string> &names,
                      const std::vector<std::string> &results,
                      const std::vector<SweepRun> &runs)
{
  const std::string heading = title.empty() ? "Sweep" : html_text(title);
  out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta "
         "charset=\"utf-8\">\n<meta name=\"viewport\" "
         "content=\"width=device-width\">\n<title>"
      << heading << "</title>\n<style>\n"
      << page_css << "</style>\n</head>\n<body>\n<h1>" << heading
      << "</h1>\n<p>Runs over "
      << html_text(boost::algorithm::join(names, ", ")) << ": "
      << counts_of(runs) << ".";
  if (const auto extremes = extreme_factors(runs))
  {
    const SweepRun &least = runs[extremes->least.second];
    out << " The least load factor is " << text_of_number(extremes->least.first)
        << ", with " << html_text(words_of(names, least.values));
    if (!least.page.empty())
      out << " (<a href=\"" << html_text(least.page) << "\">its page</a>)";
    out << ".";
  }
  out << "</p>\n<p><span class=\"swatch line of-carried\"></span> carried "
         "<span "
         "class=\"swatch line of-hinge\"></span> collapse</p>\n";
  auto shown = columns;
  for (const std::string &result : results)
    shown.emplace_back(result, result);
  for (std::size_t k = 0; names.size() == 1 && k < shown.size(); ++k)
  {
    const auto &[name, path] = shown[k];
    if (k < columns.size() && worth_a_plot.count(name) == 0)
      continue;
    const std::vector<PlotPoint> points = plotted_points(path, runs);
    if (points.size() < 2)
      continue;
    out << plot_svg(names[0], name, points, is_by_ratio(points));
    if (const std::size_t n = n_infinite(path, runs))
      out << "<p>" << html_text(name) << " has no bound in " << n << " of "
          << counted(runs.size(), "run")
          << ", which the plot leaves out.</p>\n";
  }
  write_sweep_table(out, names, shown, runs);
  for (const SharedWarning &warning : warnings_of(runs))
    out << "<p class=\"warning\">"
        << html_text(warning.description(names, runs)) << "</p>\n";
  out << "</body>\n</html>\n";
}
} // namespace Voussoir
