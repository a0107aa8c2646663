// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/capacity/capacity_curve.h>
#include <voussoir/analyses/ranges/ranges.h>
#include <voussoir/base/text.h>
#include <voussoir/output/report/colour_scale.h>
#include <voussoir/output/report/html_table.h>
#include <voussoir/output/report/plot.h>
#include <voussoir/output/report/sections.h>
#include <voussoir/output/summary/ground_summary.h>
#include <voussoir/output/summary/link_summary.h>
#include <voussoir/output/summary/messages.h>
#include <voussoir/output/summary/scene_summary.h>
#include <voussoir/output/summary/versions.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

/** A number, over the largest of its kind, that is rounding. */
constexpr double rounding = 1e-10;

/** A number, or zero if it is rounding beside @p largest. */
double shown(const double number, const double largest)
{
  return std::abs(number) <= rounding * largest ? 0. : number;
}

/** Two numbers of a summary as a text. @param largest of their kind. */
std::string pair(const Json &json, const double largest)
{
  return json.is_null() ? ""
                        : text('(', shown(json[0].get<double>(), largest), ", ",
                               shown(json[1].get<double>(), largest), ')');
}

double largest_reaction(const Results &results)
{
  double largest = 0.;
  for (const Reaction &reaction : results.reactions)
    largest = std::max(largest, reaction.force.norm());
  return largest;
}

/** The larger side of the box around the packing. */
double extent_of(const RunRecord &run)
{
  const dealii::BoundingBox<2> box = run.scene.packing.box();
  return std::max(box.side_length(0), box.side_length(1));
}

/** The names and values of the run as a whole. */
HtmlTable table_of_run(const RunRecord &run, const UnitNames &names)
{
  const Packing<2> &packing = run.scene.packing;
  const dealii::BoundingBox<2> box = packing.box();
  HtmlTable table("run", "The run");
  table.row(
      {"Packing", text(counted(packing.n_cells(), "block"), ", ",
                       counted(packing.interfaces().size(), "joint"), ", ",
                       packing.n_supports(), " of them supports, on ",
                       html_text(UnitNames::labelled(
                           text(box.side_length(0), " x ", box.side_length(1)),
                           names.length)))});
  table.row({"Model", run.scene.turns() ? "blocks slide and turn"
                                        : "blocks slide and do not turn"});
  const Json loads = loads_summary(run.scene);
  table.row(
      {"Loads", html_text(UnitNames::labelled(
                    pair(loads.at("total"), 0.) + " in all", names.force))});
  return table;
}

std::string table_of_reactions(const Results &results, const UnitNames &names)
{
  const auto with = [](const std::string &name, const std::string &unit) {
    return UnitNames::labelled(name, unit);
  };
  HtmlTable table("reactions", "Reactions of the supports, from left to right",
                  {with("from", names.length), with("to", names.length),
                   with("force on the packing", names.force),
                   with("at", names.length)});
  const Json ground = ground_summary(results);
  const double extent = extent_of(results), largest = largest_reaction(results);
  for (const Json &support : ground.at("supports"))
    table.row({pair(support.at("from"), extent), pair(support.at("to"), extent),
               pair(support.at("reaction"), largest),
               pair(support.at("at"), extent)});
  const double imbalance = ground.at("imbalance");
  table.row({"all", "", pair(ground.at("reaction"), largest),
             imbalance <= rounding ? "which balances the loads"
                                   : text("which misses the loads by ",
                                          imbalance, " of their sizes")});
  return table.close();
}

std::string table_of_most_used(const Results &results, const UnitNames &names)
{
  HtmlTable table("most-used", "The joints of which most is used",
                  {"joint", "blocks", UnitNames::labelled("at", names.length),
                   "share of the strength"});
  for (const Json &joint : most_used_summary(results))
  {
    const unsigned int e = joint.at("interface");
    const int other = joint.at("cells")[1];
    table.row(
        {text("<a href=\"#view=utilisation&amp;joint=", e, "\">", e, "</a>"),
         text(joint.at("cells")[0].get<int>(), " and ",
              other < 0 ? "the ground" : text(other)),
         pair(joint.at("at"), extent_of(results)),
         joint.at("utilisation").is_null()
             ? "without bound"
             : text(joint.at("utilisation").get<double>())});
  }
  return table.close();
}

std::string table_of_links(const Results &results, const UnitNames &names)
{
  HtmlTable table("links", "Ties, props and fill",
                  {"name",
                   UnitNames::labelled("force, tension positive", names.force),
                   "least", "most", "share of the bound"});
  for (const Json &link : links_summary(results))
  {
    const double least = link.at("least"), most = link.at("most");
    table.row({html_text(link.at("name")),
               text(shown(link.at("force").get<double>(), most - least)),
               text(least), text(most),
               text(shown(link.at("utilisation").get<double>(), 1.))});
  }
  return table.close();
}

/** The cells of a row with the ends of a range. */
void add_range(const Range &range,
               const Ranges &ranges,
               std::vector<std::string> &row)
{
  for (const double end : {range.least, range.greatest})
    row.push_back(std::isfinite(end) ? text(shown(end, ranges.reference))
                                     : "without bound");
}

/** The ranges of reactions and of ties over all states. */
std::string tables_of_ranges(const Results &results, const UnitNames &names)
{
  const auto *const ranges = results.data<Ranges>();
  if (ranges == nullptr)
    return {};
  const auto force = [&](const std::string &name) {
    return UnitNames::labelled(name, names.force);
  };
  const auto place = [&](const dealii::Point<2> &x) {
    return pair(Json::array({x[0], x[1]}), extent_of(results));
  };
  HtmlTable reactions("ranges-of-reactions",
                      "Reactions in all states that carry the loads",
                      {UnitNames::labelled("from", names.length),
                       UnitNames::labelled("to", names.length), "along",
                       force("least"), force("greatest")});
  for (unsigned int s = 0; s < ranges->reactions.size(); ++s)
    for (unsigned int d = 0; d < 2; ++d)
    {
      std::vector<std::string> row = {place(ranges->supports[s].start),
                                      place(ranges->supports[s].end),
                                      d == 0 ? "x" : "y"};
      add_range(ranges->reactions[s][d], *ranges, row);
      reactions.row(row);
    }
  HtmlTable links("ranges-of-links",
                  "Ties, props and fill in all states that carry the loads",
                  {"name", UnitNames::labelled("at", names.length),
                   force("force, least"), "greatest"});
  for (unsigned int k = 0; k < ranges->links.size(); ++k)
  {
    const Link &link = results.scene.links[k];
    std::vector<std::string> row = {html_text(link.name), place(link.on_minus)};
    add_range(ranges->links[k], *ranges, row);
    links.row(row);
  }
  return (ranges->reactions.empty() ? "" : reactions.close()) +
         (ranges->links.empty() ? "" : links.close());
}

/** The plot of a capacity curve. */
std::string plot_of(const CapacityCurve &curve, const UnitNames &names)
{
  std::vector<PlotPoint> points;
  for (const CapacityPoint &point : curve.points)
    points.push_back({point.displacement, point.carried, "carried"});
  return "<section id=\"capacity\">\n<h2>Capacity curve</h2>\n" +
         plot_svg(UnitNames::labelled("displacement", names.length),
                  "factor of the live loads", points, false) +
         "<p>" + html_text("It ends where " + curve.end + ".") +
         "</p>\n</section>\n";
}

/** A value, or of a long list what it begins with. */
std::string beginning_of(const std::string &value)
{
  constexpr std::size_t longest = 300;
  return value.size() <= longest
             ? value
             : value.substr(0, longest) + "... (all in parameters.prm)";
}

/** What the user has set, and with what the results were made. */
std::string closing_tables(const RunRecord &run, const ReportDetails &details)
{
  HtmlTable parameters("parameters",
                       "Parameters that differ from their defaults");
  for (const auto &[name, value] : details.parameters)
    parameters.row({html_text(name), html_text(beginning_of(value))});
  HtmlTable times("times", "Time", {"stage", "seconds"});
  for (const auto &[stage, seconds] : run.timings)
    times.row({html_text(stage), text(seconds)});
  HtmlTable versions("versions", "Versions");
  const Json of_libraries = library_versions();
  for (const auto &[name, version] : of_libraries.items())
    versions.row({html_text(name), html_text(version.get<std::string>())});
  return parameters.close() + times.close() + versions.close();
}
} // namespace

std::string sections_of(const Results &results, const ReportDetails &details)
{
  HtmlTable run = table_of_run(results, details.units);
  run.row({"Forces", html_text(results.selection)});
  if (!results.scene.coefficient.empty())
    run.row({"Friction", html_text(description_of_law(results.scene))});
  for (const AnalysisResult &analysis : results.analyses)
    if (!analysis.is_verdict || !analysis.sentence.empty())
      run.row({analysis.title, html_text(analysis.description)});
  const auto *const curve = results.data<CapacityCurve>();
  return (curve != nullptr ? plot_of(*curve, details.units) : "") +
         run.close() +
         (results.reactions.empty()
              ? ""
              : table_of_reactions(results, details.units)) +
         (results.scene.links.empty()
              ? ""
              : table_of_links(results, details.units)) +
         tables_of_ranges(results, details.units) +
         table_of_most_used(results, details.units) +
         closing_tables(results, details);
}

std::string sections_of(const Collapse &collapse, const ReportDetails &details)
{
  HtmlTable parts("work", "The work of the loads along the mechanism",
                  {"loads", "share of the work that is put in"});
  double all = 0.;
  for (const LoadPart &part : collapse.parts)
    all += std::max(0., part.work);
  for (const LoadPart &part : collapse.parts)
    parts.row({html_text(part.name), text(shown(part.work / all, 1.))});
  return table_of_run(collapse, details.units).close() + parts.close() +
         closing_tables(collapse, details);
}
} // namespace Voussoir
