// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/report/colour_scale.h>
#include <voussoir/output/summary/text_lines.h>
#include <voussoir/report_page.h>
#include <voussoir/run/sweep/envelope.h>
#include <voussoir/run/sweep/sweep_factors.h>
#include <voussoir/run/sweep/sweep_files.h>
#include <voussoir/run/sweep/sweep_page.h>
#include <voussoir/run/sweep/sweep_plots.h>
#include <voussoir/run/sweep/sweep_results.h>
#include <voussoir/sweep_style.h>
#include <voussoir/version.h>

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ostream>

namespace Voussoir
{
namespace
{
/** A number that is rounding, over the largest of its column or one. */
constexpr double rounding_in_tables = 1e-12;

/** A number in a sentence. */
std::string number_in_sentence(const double number)
{
  return std::abs(number) < rounding_in_tables
             ? "0"
             : short_value(value_text(number));
}

/** How often each status is there, in the words of a page. */
std::string counts_in_words(const std::vector<SweepRun> &runs)
{
  std::string words;
  for (const auto &[status, in_words] :
       {std::pair("solved", "carried"),
        std::pair("carried to within", "carried to within a small error"),
        std::pair("collapse", "not carried"),
        std::pair("unloaded", "without live loads"),
        std::pair("packing", "without loads"),
        std::pair("failed", "without an answer")})
    if (const auto n = std::count_if(
            runs.begin(), runs.end(),
            [of = status](const SweepRun &run) { return word_of(run) == of; }))
      words += text(words.empty() ? "" : ", ", n, ' ', in_words);
  return words;
}

/** The factor of a run in a sentence. */
std::string factor_in_sentence(const SweepRun &run)
{
  return number_in_sentence(*factor_of(run));
}

/** The way to a page, around words; the words alone if there is no page. */
std::string link_to(const std::string &page, const std::string &words)
{
  return page.empty() ? words
                      : "<a href=\"" + html_text(page) + "\">" + words + "</a>";
}

/** The way to a run: to its page, or to its line in the table. */
std::string link_to_run(const SweepRun &run, const std::size_t k)
{
  return run.page.empty() ? link_to(text("#run-", k + 1), "its line")
                          : link_to(run.page, "its page");
}

/** ", with Position = -3.4 (its page)". */
std::string where_in_words(const SweepPage &page, const std::size_t k)
{
  const SweepRun &run = page.runs[k];
  return html_text(short_words_of(short_names(page.names), run.values)) +
         (run.page.empty() ? "" : " (" + link_to(run.page, "its page") + ')');
}

std::string sentence_on_factors(const SweepPage &page)
{
  const auto extremes = extreme_factors(page.runs);
  if (!extremes)
    return {};
  const auto of = [&](const std::size_t k) {
    return factor_in_sentence(page.runs[k]) + ", with " +
           where_in_words(page, k);
  };
  if (extremes->has_both())
    return " The greatest of the least load factors is " +
           of(*extremes->lower) + ", the least of the greatest " +
           of(*extremes->upper) + '.';
  return extremes->upper
             ? " The least load factor is " + of(*extremes->upper) + '.'
             : " The greatest of the least load factors is " +
                   of(*extremes->lower) + '.';
}

/** Between which runs a search has ended. */
std::string section_on_ends(const SweepPage &page)
{
  if (!page.ends)
    return {};
  const SweepRun &carried = page.runs[page.ends->carried];
  const SweepRun &collapses = page.runs[page.ends->collapses];
  const double a = std::stod(carried.values[0]);
  const double b = std::stod(collapses.values[0]);
  const double width = std::abs(a - b) / std::max(std::abs(a), std::abs(b));
  const int n_digits = std::clamp(-std::log10(width), 3., 12.);
  std::string html =
      "<section id=\"ends\">\n<p>The answer changes at " +
      html_text(page.names[0]) + " = " +
      text_with_digits(0.5 * (a + b), n_digits) + ", known to " +
      number_in_sentence(width) + " of it" +
      (page.ends->is_open ? "; between the two values the answer is open"
                          : "") +
      ".</p>\n<div class=\"scrolls\"><table>\n";
  const auto add = [&](const SweepRun &run, const std::string &kind,
                       const std::string &words) {
    html += "<tr><td class=\"verdict-of " + kind + "\">" +
            link_to(run.page, words) + "</td><td>" + html_text(page.names[0]) +
            " = " + html_text(run.values[0]) + "</td></tr>\n";
  };
  add(carried, "carried", "carried");
  add(collapses, "collapse", "not carried");
  return html + "</table></div>\n</section>\n";
}

std::string heading_of_curves(const FactorExtremes &extremes)
{
  if (extremes.has_both())
    return "The critical load factor of each curve";
  return extremes.upper ? "The least load factor of each curve"
                        : "The greatest of the least load factors of each "
                          "curve";
}

/** The most critical run of each curve. */
std::string table_of_curves(const SweepPage &page,
                            const SweepLayout &layout,
                            const Envelope &envelope)
{
  if (!envelope.exists() || layout.form == SweepLayout::Form::map)
    return {};
  const auto extremes = extreme_factors(page.runs);
  const std::size_t critical = extremes->critical(page.runs);
  const std::vector<std::string> in_short = short_names(page.names);
  const auto is_shown = [&](const std::size_t n) {
    return page.names[n] == layout.along.name ||
           std::find(layout.others.begin(), layout.others.end(),
                     page.names[n]) != layout.others.end();
  };
  std::string html = "<section id=\"curves\">\n<h2>" +
                     heading_of_curves(*extremes) +
                     "</h2>\n<div class=\"scrolls\"><table>\n"
                     "<tr>";
  for (std::size_t n = 0; n < in_short.size(); ++n)
    if (is_shown(n))
      html += "<th>" + html_text(in_short[n]) + "</th>";
  html += "<th>load factor</th><th>run</th></tr>\n";
  for (std::size_t curve = 0; curve < layout.runs.size(); ++curve)
  {
    const std::size_t k = envelope.of_curve[curve];
    if (k == SweepLayout::no_run)
      continue;
    const SweepRun &run = page.runs[k];
    html += k == critical ? "<tr class=\"critical\">" : "<tr>";
    for (std::size_t n = 0; n < in_short.size(); ++n)
      if (is_shown(n))
        html += "<td>" + html_text(run.values[n]) + "</td>";
    html += "<td>" + value_text(*factor_of(run)) + "</td><td>" +
            link_to_run(run, k) + "</td></tr>\n";
  }
  html += "</table></div>\n";
  const std::size_t n_without = std::count(
      envelope.of_curve.begin(), envelope.of_curve.end(), SweepLayout::no_run);
  if (n_without > 0)
    html += text("<p>", n_without, " of ",
                 counted(envelope.of_curve.size(), "curve"),
                 " have no finite factor.</p>\n");
  return html + "</section>\n";
}

/** What the page of a run says first: its sentence up to the proof. */
std::string verdict_in_words(const SweepRun &run)
{
  if (run.is_unloaded)
    return "No live loads: there is nothing to be multiplied.";
  if (!run.has_answer)
    return "No answer: " + run.reason;
  const std::string head = run.sentence.substr(0, run.sentence.find(": "));
  return head.find("carried") != head.npos && head.size() < run.sentence.size()
             ? head + '.'
             : run.sentence;
}

/** The table of all runs, without columns that none has. */
class TableOfRuns
{
public:
  explicit TableOfRuns(const SweepPage &page) : page(page)
  {
    std::vector<SweepColumn> all = sweep_columns;
    for (const std::string &result : page.results)
      all.emplace_back(result, result);
    for (const SweepColumn &column : all)
      if (std::any_of(page.runs.begin(), page.runs.end(),
                      [&](const SweepRun &run) {
                        return !result_at(run.summary, column.second).empty();
                      }))
        columns.push_back(column);
    for (const SweepColumn &column : columns)
      largest.push_back(largest_in(column));
  }

  void write(std::ostream &out)
  {
    out << "<div class=\"scrolls\"><table>\n<tr>";
    for (const std::string &name : page.names)
      out << "<th>" << html_text(name) << "</th>";
    out << "<th>verdict</th>";
    for (const SweepColumn &column : columns)
      out << "<th>" << html_text(column.first) << "</th>";
    out << "</tr>\n";
    for (std::size_t k = 0; k < page.runs.size(); ++k)
      write_row(out, k);
    out << "</table></div>\n<p>The same is in " << sweep_csv << '.'
        << (has_rounding
                ? " 'rounding' stands for a number below 1e-12, or 1e-12 of "
                  "the largest in its column."
                : "")
        << "</p>\n";
  }

private:
  /** The largest size in a column, at least one. */
  double largest_in(const SweepColumn &column) const
  {
    double largest = 1.;
    for (const SweepRun &run : page.runs)
      if (const auto number = number_at(run.summary, column.second);
          number && std::isfinite(*number))
        largest = std::max(largest, std::abs(*number));
    return largest;
  }

  void write_row(std::ostream &out, const std::size_t k)
  {
    const SweepRun &run = page.runs[k];
    out << "<tr>";
    for (std::size_t n = 0; n < run.values.size(); ++n)
      out << (n == 0 ? text("<td id=\"run-", k + 1, "\">") : "<td>")
          << html_text(run.values[n]) << "</td>";
    out << "<td class=\"verdict-of " << kind_of_verdict(run) << "\" title=\""
        << html_text(run.sentence) << "\">"
        << link_to(run.page, html_text(verdict_in_words(run))) << "</td>";
    for (std::size_t n = 0; n < columns.size(); ++n)
      out << "<td>" << number_in_column(run, n) << "</td>";
    out << "</tr>\n";
  }

  std::string number_in_column(const SweepRun &run, const std::size_t n)
  {
    const std::optional<double> number =
        number_at(run.summary, columns[n].second);
    if (number && *number != 0. &&
        std::abs(*number) < rounding_in_tables * largest[n])
    {
      has_rounding = true;
      return "rounding";
    }
    return html_text(result_at(run.summary, columns[n].second));
  }

  const SweepPage &page;
  std::vector<SweepColumn> columns;
  std::vector<double> largest;
  bool has_rounding = false;
};
} // namespace

void write_sweep_html(std::ostream &out, const SweepPage &page)
{
  const std::string heading =
      page.title.empty() ? "Sweep" : html_text(page.title);
  const SweepLayout layout = layout_of(page.names, page.runs);
  const Envelope envelope = envelope_of(layout, page.runs);
  out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta "
         "charset=\"utf-8\">\n<meta name=\"viewport\" "
         "content=\"width=device-width\">\n<title>"
      << heading << "</title>\n<style>\n"
      << page_css << sweep_css << "</style>\n</head>\n<body>\n<h1>" << heading
      << "</h1>\n<p>Runs over "
      << html_text(boost::algorithm::join(page.names, ", ")) << ": "
      << counts_in_words(page.runs) << '.' << sentence_on_factors(page)
      << "</p>\n"
      << section_on_ends(page)
      << plots_of(layout, envelope, page.results, page.runs)
      << table_of_curves(page, layout, envelope)
      << "<section id=\"runs\">\n<h2>All runs</h2>\n";
  TableOfRuns(page).write(out);
  out << "</section>\n";
  for (const SharedWarning &warning : warnings_of(page.runs))
    out << "<p class=\"warning\">"
        << html_text(warning.description(page.names, page.runs)) << "</p>\n";
  out << "<footer>Made by Voussoir " << VOUSSOIR_VERSION
      << ".</footer>\n</body>\n</html>\n";
}
} // namespace Voussoir
