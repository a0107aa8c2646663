// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/capacity/capacity_curve.h>
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

#include <cmath>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

/** Two numbers of a summary as a text. */
std::string pair(const Json &json)
{
  return json.is_null() ? ""
                        : text('(', json[0].get<double>(), ", ",
                               json[1].get<double>(), ')');
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
  table.row({"Loads", html_text(UnitNames::labelled(
                          pair(loads.at("total")) + " in all", names.force))});
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
  for (const Json &support : ground.at("supports"))
    table.row({pair(support.at("from")), pair(support.at("to")),
               pair(support.at("reaction")), pair(support.at("at"))});
  table.row({"all", "", pair(ground.at("reaction")),
             text("the loads to ", ground.at("imbalance").get<double>(),
                  " of their sizes")});
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
         pair(joint.at("at")),
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
    table.row({html_text(link.at("name")), text(link.at("force").get<double>()),
               text(link.at("least").get<double>()),
               text(link.at("most").get<double>()),
               text(link.at("utilisation").get<double>())});
  return table.close();
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

std::string certificate_of(const Results &results)
{
  const Certificate &of = results.certificate;
  std::string words =
      text("Computed from the forces alone: the forces on each block add up to "
           "zero within ",
           of.equilibrium_residual,
           " of the largest load on a block, and no joint bears more than its "
           "limits by more than ",
           of.admissibility_violation, " of it.");
  if (results.scene.turns())
    words += text(" Their moments add up to zero within ", of.moment_residual,
                  " of that load times the size of the block.");
  else
    words += text(" Blocks do not turn, and moments up to ", of.max_torque,
                  " of that load times the size of the block remain.");
  return words;
}

std::string certificate_of(const Collapse &collapse)
{
  const MechanismCertificate &of = collapse.proof;
  return text(
      "Computed from the motion alone: no joint closes by more than ",
      of.closing_violation, " of the largest displacement, and the loads do ",
      std::isfinite(of.work_over_dissipation)
          ? text(of.work_over_dissipation, " times the work that the joints "
                                           "can dissipate.")
          : "work that the joints do not resist.");
}

std::string section(const std::string &id,
                    const std::string &heading,
                    const std::string &words)
{
  return "<section id=\"" + id + "\">\n<h2>" + heading + "</h2>\n<p>" +
         html_text(words) + "</p>\n</section>\n";
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

std::string verdict_of(const Results &results)
{
  for (const AnalysisResult &analysis : results.analyses)
    if (analysis.is_verdict)
      return analysis.sentence.empty()
                 ? analysis.title + ": " + analysis.description + "."
                 : analysis.sentence;
  if (results.status.kind == Status::Kind::carried_within)
    return text("The loads are carried to within ", results.status.within,
                " of the largest: whether they are carried exactly is open.");
  return results.scene.packing.n_supports() == 0
             ? "The loads are carried: forces within the limits of all joints "
               "balance them."
             : "The loads are carried: forces within the limits of all joints "
               "and supports balance them.";
}

std::string verdict_of(const Collapse &collapse)
{
  return message_of(collapse, "");
}

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
         table_of_most_used(results, details.units) +
         section("certificate", "Certificate", certificate_of(results)) +
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
    parts.row({html_text(part.name), text(part.work / all)});
  return table_of_run(collapse, details.units).close() + parts.close() +
         section("certificate", "Certificate", certificate_of(collapse)) +
         closing_tables(collapse, details);
}
} // namespace Voussoir
