// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/report/colour_scale.h>
#include <voussoir/output/report/curves_plot.h>
#include <voussoir/output/report/map_plot.h>
#include <voussoir/run/sweep/sweep_factors.h>
#include <voussoir/run/sweep/sweep_plots.h>
#include <voussoir/run/sweep/sweep_results.h>

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace Voussoir
{
namespace
{
using Form = SweepLayout::Form;

/** The columns that have a plot, besides those that the user names. */
const std::set<std::string> worth_a_plot = {"load_factor", "max_utilisation",
                                            "work_over_dissipation"};

/** The column that has an envelope. */
const std::string of_factors = "load_factor";

/** The ratio of factors above which an axis is logarithmic. */
constexpr double most_ratio_of_factors = 10.;

/** A factor, over the largest, that is zero but for rounding. */
constexpr double same_as_zero = 1e-9;

/** Draws one column over what a layout says. */
class ColumnPlot
{
public:
  ColumnPlot(const SweepLayout &layout,
             const SweepColumn &column,
             const std::vector<SweepRun> &runs)
      : layout(layout), column(column), runs(runs)
  {
    for (const SweepRun &run : runs)
      numbers.push_back(number_at(run.summary, column.second));
  }

  /** The number of points that a plot would have. */
  std::size_t n_points() const
  {
    return count([&](const std::size_t k) { return is_finite(k); });
  }

  std::string curves(const Envelope &envelope) const
  {
    const bool by_ratio = envelope.exists() && is_far_apart();
    CurvesPlot plot = {range_of_x(),
                       column.first + (by_ratio ? ", logarithmic" : ""),
                       by_ratio,
                       {}};
    for (std::size_t curve = 0; curve < layout.runs.size(); ++curve)
      plot.curves.push_back(
          {layout.labels[curve], parts_of(layout.runs[curve])});
    if (column.first == of_factors && envelope.exists())
      add_envelope(plot, envelope);
    add_marks(plot);
    return scrolled(curves_svg(plot)) + curves_key(plot) + notes(plot);
  }

  std::string map() const
  {
    MapPlot plot = {layout.along.numbers,
                    layout.across.numbers,
                    layout.along.name,
                    layout.across.name,
                    layout.along.is_by_ratio(),
                    layout.across.is_by_ratio(),
                    {}};
    for (std::size_t j = 0; j < layout.runs.size(); ++j)
    {
      plot.fields.emplace_back();
      for (std::size_t i = 0; i < layout.runs[j].size(); ++i)
        plot.fields.back().push_back(layout.runs[j][i] == SweepLayout::no_run
                                         ? MapField()
                                         : field_of(j, i));
    }
    return scrolled(map_svg(plot)) + map_key(plot, column.first) +
           notes_of_map();
  }

private:
  bool is_finite(const std::size_t k) const
  {
    return numbers[k] && std::isfinite(*numbers[k]);
  }

  /** @{ */
  /** Why a run has no point, if it is one of those. */
  bool is_unbounded(const std::size_t k) const
  {
    return numbers[k] && !std::isfinite(*numbers[k]);
  }
  bool is_not_carried(const std::size_t k) const
  {
    return !numbers[k] && runs[k].verdict == Status::Kind::collapse;
  }
  bool is_without_answer(const std::size_t k) const
  {
    return !runs[k].has_answer;
  }
  /** @} */

  std::size_t count(const std::function<bool(std::size_t)> &is_one) const
  {
    std::size_t n = 0;
    for (std::size_t k = 0; k < runs.size(); ++k)
      n += is_one(k);
    return n;
  }

  static std::string scrolled(const std::string &svg)
  {
    return "<div class=\"scrolls\">\n" + svg + "</div>\n";
  }

  /** True for load factors of which the least would be on the axis of x. */
  bool is_far_apart() const
  {
    if (column.first != of_factors)
      return false;
    const auto extremes = extreme_factors(runs);
    const double least = *numbers[extremes->least];
    const double greatest = *numbers[extremes->greatest];
    return least > same_as_zero * greatest &&
           greatest > most_ratio_of_factors * least;
  }

  double x_at(const std::size_t place) const
  {
    return layout.along.numbers.empty() ? double(place)
                                        : layout.along.numbers[place];
  }

  PlotRange range_of_x() const
  {
    const SweptEntry &along = layout.along;
    if (along.numbers.empty())
      return {along.name, 0., 0., false, along.values};
    return {along.name, along.numbers.front(), along.numbers.back(),
            along.is_by_ratio()};
  }

  /** Points of runs by their values along x, up to those without a number. */
  std::vector<std::vector<PlotPoint>>
  parts_of(const std::vector<std::size_t> &of_places) const
  {
    std::vector<std::vector<PlotPoint>> parts(1);
    for (std::size_t place = 0; place < of_places.size(); ++place)
    {
      const std::size_t k = of_places[place];
      if (k != SweepLayout::no_run && is_finite(k))
        parts.back().push_back(
            {x_at(place), *numbers[k], kind_of_verdict(runs[k])});
      else if (!parts.back().empty())
        parts.emplace_back();
    }
    return parts;
  }

  void add_envelope(CurvesPlot &plot, const Envelope &envelope) const
  {
    const auto extremes = extreme_factors(runs);
    const std::string label =
        extremes->has_both()
            ? "envelope: what all curves carry"
            : "envelope: " + words_of_critical(*extremes) + " at each place";
    for (const auto *const side : {&envelope.lower, &envelope.upper})
      if (std::any_of(side->begin(), side->end(), [](const std::size_t k) {
            return k != SweepLayout::no_run;
          }))
        plot.envelopes.push_back({label, parts_of(*side)});
    const std::size_t critical = extremes->critical(runs);
    for (const auto &of_places : layout.runs)
      for (std::size_t place = 0; place < of_places.size(); ++place)
        if (of_places[place] == critical)
          plot.extreme = {x_at(place), *numbers[critical], ""};
  }

  void add_marks(CurvesPlot &plot) const
  {
    std::map<std::pair<std::size_t, std::string>, std::vector<std::string>>
        marks;
    for (std::size_t curve = 0; curve < layout.runs.size(); ++curve)
      for (std::size_t place = 0; place < layout.along.values.size(); ++place)
      {
        const std::size_t k = layout.runs[curve][place];
        if (k == SweepLayout::no_run)
          continue;
        const std::string label = layout.labels[curve];
        const std::string words = label + (label.empty() ? "" : ", ") +
                                  layout.along.name + " = " +
                                  short_value(layout.along.values[place]);
        if (is_not_carried(k))
          marks[{place, "collapse"}].push_back("Not carried: " + words);
        else if (is_without_answer(k))
          marks[{place, "none"}].push_back(
              (runs[k].is_unloaded ? "No live loads: " : "No answer: ") +
              words);
      }
    for (const auto &[where, words] : marks)
      plot.marks.push_back({x_at(where.first), where.second,
                            boost::algorithm::join(words, "\n")});
  }

  /** The colours of kinds, and what has no point. */
  std::string notes(const CurvesPlot &plot) const
  {
    std::string html;
    const auto add = [&](const std::string &sign, const std::string &words) {
      html += "<li>" + sign + ' ' + words + "</li>\n";
    };
    if (plot.curves.size() == 1)
      for (const auto &[kind, words] :
           {std::pair("carried", "carried"),
            std::pair("within", "carried to within a small error"),
            std::pair("collapse", "not carried")})
        if (count([&, of = std::string(kind)](const std::size_t k) {
              return is_finite(k) && kind_of_verdict(runs[k]) == of;
            }))
          add("<span class=\"swatch line of-" + std::string(kind) +
                  "\"></span>",
              words);
    if (plot.extreme)
      add("\u25ef", words_of_critical(*extreme_factors(runs)) + " of all");
    const auto n_of = [&](const std::size_t n) {
      return text(" in ", n, " of ", counted(runs.size(), "run"));
    };
    if (const std::size_t n =
            count([&](const std::size_t k) { return is_not_carried(k); }))
      add("<span class=\"cross-key\">\u00d7</span>", "not carried" + n_of(n));
    for (const bool is_unloaded : {true, false})
      if (const std::size_t n = count([&](const std::size_t k) {
            return is_without_answer(k) && runs[k].is_unloaded == is_unloaded;
          }))
        add("<span class=\"cross-key none\">\u00d7</span>",
            (is_unloaded ? "no live loads" : "no answer") + n_of(n));
    return (html.empty() ? "" : "<ul class=\"keys\">\n" + html + "</ul>\n") +
           note_on_unbounded();
  }

  std::string note_on_unbounded() const
  {
    const std::size_t n =
        count([&](const std::size_t k) { return is_unbounded(k); });
    if (n == 0)
      return {};
    return "<p>" + html_text(column.first) +
           text(" has no bound in ", n, " of ", counted(runs.size(), "run"),
                ", which the plot leaves out.</p>\n");
  }

  /** That of the run in row @p j and column @p i. */
  MapField field_of(const std::size_t j, const std::size_t i) const
  {
    const std::size_t k = layout.runs[j][i];
    MapField field;
    const std::string number = numbers[k] ? text(*numbers[k]) : "";
    field.words =
        short_words_of({layout.along.name, layout.across.name},
                       {layout.along.values[i], layout.across.values[j]}) +
        ": ";
    if (is_finite(k))
    {
      field.number = *numbers[k];
      field.words += number;
    }
    else if (is_unbounded(k))
    {
      field.kind = "unbounded";
      field.words += "no bound";
    }
    else if (is_not_carried(k))
    {
      field.kind = "collapse";
      field.words += "not carried";
    }
    else
    {
      field.kind = "none";
      field.words += runs[k].is_unloaded   ? "no live loads"
                     : !runs[k].has_answer ? "no answer"
                     : runs[k].verdict     ? "carried"
                                           : "no loads";
    }
    if (runs[k].verdict)
      field.side =
          runs[k].verdict != Status::Kind::collapse &&
          (!has_both_sides_of_one() || !numbers[k] || *numbers[k] >= 1.);
    return field;
  }

  /** True for load factors some of which carry the live loads once. */
  bool has_both_sides_of_one() const { return column.first == of_factors; }

  std::string notes_of_map() const
  {
    std::string html;
    const auto add = [&](const std::string &kind, const std::string &words,
                         const std::size_t n) {
      if (n > 0)
        html += "<li><span class=\"swatch " + kind + "\"></span> " + words +
                text(" in ", n, " of ", counted(runs.size(), "run")) +
                "</li>\n";
    };
    add("of-field", "not carried",
        count([&](const std::size_t k) { return is_not_carried(k); }));
    add("missing", "without bound",
        count([&](const std::size_t k) { return is_unbounded(k); }));
    add("of-none", "without this number", count([&](const std::size_t k) {
          return !numbers[k] && !is_not_carried(k);
        }));
    return (html.empty() ? "" : "<ul class=\"keys\">\n" + html + "</ul>\n") +
           (has_both_sides_of_one()
                ? "<p>A line parts factors of one and more from those below "
                  "one, or from what is not carried.</p>\n"
                : "<p>A line parts what is carried from what is not.</p>\n");
  }

  const SweepLayout &layout;
  const SweepColumn &column;
  const std::vector<SweepRun> &runs;
  std::vector<std::optional<double>> numbers;
};
} // namespace

std::string plots_of(const SweepLayout &layout,
                     const Envelope &envelope,
                     const std::vector<std::string> &results,
                     const std::vector<SweepRun> &runs)
{
  if (layout.form == Form::table)
    return "<p>There would be " + text(layout.runs.size()) + " curves over " +
           html_text(layout.along.name) +
           text(", one for each combination of the others, and no more than ",
                most_curves_in_plot,
                " can be told apart: there is no plot, and the table has all "
                "of them.</p>\n");
  std::vector<SweepColumn> columns;
  for (const SweepColumn &column : sweep_columns)
    if (worth_a_plot.count(column.first))
      columns.push_back(column);
  for (const std::string &result : results)
    columns.emplace_back(result, result);
  std::string html;
  for (const SweepColumn &column : columns)
  {
    const ColumnPlot plot(layout, column, runs);
    if (plot.n_points() > 1)
      html += "<section class=\"plot-of\" id=\"plot-" +
              html_text(column.first) + "\">\n" +
              (layout.form == Form::map ? plot.map() : plot.curves(envelope)) +
              "</section>\n";
  }
  return html;
}
} // namespace Voussoir
