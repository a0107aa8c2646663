// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/report/colour_scale.h>
#include <voussoir/output/report/plot.h>
#include <voussoir/report_page.h>
#include <voussoir/sweep_files.h>
#include <voussoir/sweep_values.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/lexical_cast/try_lexical_convert.hpp>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>

namespace Voussoir
{
namespace
{
using Json = nlohmann::json;

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

/** Those of them that have a plot. */
const std::set<std::string> worth_a_plot = {"load_factor", "max_utilisation",
                                            "work_over_dissipation"};

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

/** A value of the summary; empty if it has none there. */
std::string value_at(const Json &summary, const std::string &path)
{
  const Json::json_pointer place('/' + path);
  if (!summary.contains(place) || summary.at(place).is_null())
    return {};
  const Json &value = summary.at(place);
  if (value.is_number_float())
    return value_text(value.get<double>());
  return field(value.is_string() ? value.get<std::string>() : value.dump());
}

/** The numbers of @p path over the only parameter, by its values. */
std::vector<PlotPoint> plotted_points(const std::string &path,
                                      const std::vector<RunOutcome> &runs)
{
  std::vector<PlotPoint> points;
  for (const RunOutcome &run : runs)
  {
    PlotPoint point;
    if (!boost::conversion::try_lexical_convert(run.values[0], point.x) ||
        !std::isfinite(point.x))
      return {}; // words
    if (boost::conversion::try_lexical_convert(value_at(run.summary, path),
                                               point.y) &&
        std::isfinite(point.y))
    {
      point.kind = run.answer == Status::Kind::solved     ? "carried"
                   : run.answer == Status::Kind::collapse ? "collapse"
                                                          : "within";
      points.push_back(point);
    }
  }
  std::stable_sort(
      points.begin(), points.end(),
      [](const PlotPoint &a, const PlotPoint &b) { return a.x < b.x; });
  return points;
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

std::string word_of(const RunOutcome &run)
{
  return run.has_answer ? Status{run.answer, 0.}.word() : "failed";
}

void write_sweep_csv(std::ostream &out,
                     const std::vector<std::string> &names,
                     const std::vector<std::string> &results,
                     const std::vector<RunOutcome> &runs)
{
  for (const std::string &name : names)
    out << field(name) << ',';
  out << "status";
  for (const auto &column : columns)
    out << ',' << column.first;
  for (const std::string &result : results)
    out << ',' << field(result);
  out << ",seconds,message\n";
  for (const RunOutcome &run : runs)
  {
    for (const std::string &value : run.values)
      out << field(value) << ',';
    out << word_of(run);
    for (const auto &column : columns)
      out << ',' << value_at(run.summary, column.second);
    for (const std::string &result : results)
      out << ',' << value_at(run.summary, result);
    out << ',' << value_text(run.seconds) << ',' << field(run.reason) << '\n';
  }
}

void write_sweep_html(std::ostream &out,
                      const std::vector<std::string> &names,
                      const std::vector<std::string> &results,
                      const std::vector<RunOutcome> &runs)
{
  out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta "
         "charset=\"utf-8\">\n<title>Sweep</title>\n<style>\n"
      << page_css << "</style>\n</head>\n<body>\n<h1>"
      << html_text(boost::algorithm::join(names, ", ")) << "</h1>\n";
  out << "<p><span class=\"swatch line of-carried\"></span> carried <span "
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
    if (points.size() > 1)
      out << plot_svg(names[0], name, points, is_by_ratio(points));
  }
  out << "<table>\n<tr>";
  for (const std::string &name : names)
    out << "<th>" << html_text(name) << "</th>";
  out << "<th>status</th>";
  for (const auto &column : shown)
    out << "<th>" << html_text(column.first) << "</th>";
  out << "</tr>\n";
  for (const RunOutcome &run : runs)
  {
    out << "<tr>";
    for (const std::string &value : run.values)
      out << "<td>" << html_text(value) << "</td>";
    out << "<td>" << word_of(run) << "</td>";
    for (const auto &column : shown)
      out << "<td>" << html_text(value_at(run.summary, column.second))
          << "</td>";
    out << "</tr>\n";
  }
  out << "</table>\n</body>\n</html>\n";
}
} // namespace Voussoir
