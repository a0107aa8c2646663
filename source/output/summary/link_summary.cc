// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/summary/link_summary.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

/** The most links that the terminal shows. */
constexpr std::size_t n_shown_links = 12;
/** A force, over the width of its bounds, that is rounding. */
constexpr double rounding_of_link = 1e-9;

/** A tie, or all links of a body of soil on one side of blocks. */
struct LinksOfName
{
  /** One of them, with the sums of their bounds. */
  Link link;
  /** The number of them. */
  unsigned int n = 0;
  /** The sum of their forces. */
  double force = 0.;
};

/** @param forces of the links, or null. */
std::vector<LinksOfName> links_by_name(const Scene &scene,
                                       const std::vector<double> *const forces)
{
  std::vector<LinksOfName> all;
  for (unsigned int k = 0; k < scene.links.size(); ++k)
  {
    const Link &link = scene.links[k];
    const auto is_same = [&](const LinksOfName &other) {
      return link.is_of_fill && other.link.is_of_fill &&
             link.name == other.link.name &&
             link.direction * other.link.direction > 0.;
    };
    auto found = std::find_if(all.begin(), all.end(), is_same);
    if (found == all.end())
    {
      all.push_back({link, 0, 0.});
      found = all.end() - 1;
    }
    else
    {
      found->link.least += link.least;
      found->link.most += link.most;
    }
    ++found->n;
    found->force += forces ? (*forces)[k] : 0.;
  }
  return all;
}

std::string words_of_force(const Link &link, const double force)
{
  const double small = rounding_of_link * (link.most - link.least);
  if (std::abs(force) <= small)
    return "no force";
  const double bound = force < 0. ? link.least : link.most;
  return text(force < 0. ? "compression " : "tension ", std::abs(force), " of ",
              std::abs(bound),
              std::abs(force - bound) <= small ? ", which is all it bears"
                                               : "");
}

/** "pushes to the left with 27, of 3 to 27 on 4 edges". */
std::string words_of_fill(const LinksOfName &of)
{
  return text("pushes to the ", of.link.direction[0] > 0. ? "left" : "right",
              " with ", 0. - of.force, ", of ", 0. - of.link.most, " to ",
              0. - of.link.least, " on ", counted(of.n, "edge"));
}

/** The lines of the first links, and how many more there are. */
template <typename WordsOf>
std::vector<std::string> lines_of(const std::vector<LinksOfName> &links,
                                  const WordsOf &words_of)
{
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < std::min(links.size(), n_shown_links); ++k)
    lines.push_back(links[k].link.name + ": " + words_of(links[k]));
  if (links.size() > n_shown_links)
    lines.push_back(text("and ", links.size() - n_shown_links, " more"));
  return lines;
}
} // namespace

nlohmann::ordered_json links_summary(const Results &results)
{
  Json list = Json::array();
  for (const LinksOfName &of :
       links_by_name(results.scene, &results.forces.in_links))
  {
    Json entry = {{"name", of.link.name},
                  {"force", of.force},
                  {"least", of.link.least},
                  {"most", of.link.most},
                  {"utilisation", of.link.utilisation(of.force)}};
    if (of.link.is_of_fill)
      entry["edges"] = of.n;
    list.push_back(std::move(entry));
  }
  return list;
}

void show_link_forces(Terminal &terminal, const Results &results)
{
  for (const std::string &line :
       lines_of(links_by_name(results.scene, &results.forces.in_links),
                [&](const LinksOfName &of) {
                  return of.link.is_of_fill ? words_of_fill(of)
                                            : words_of_force(of.link, of.force);
                }))
    terminal.summary("Link", line);
}

void show_links(Terminal &terminal, const Scene &scene)
{
  for (const std::string &line :
       lines_of(links_by_name(scene, nullptr), [&](const LinksOfName &of) {
         const Link &link = of.link;
         const std::string bounds =
             text(", force from ", link.least, " to ", link.most);
         return link.is_of_fill
                    ? text("soil against ", counted(of.n, "edge"), bounds)
                    : text(scene.packing.describe(link.cell_minus), " at ",
                           text_of_point(link.on_minus), " - ",
                           scene.packing.describe(link.cell_plus), " at ",
                           text_of_point(link.on_plus), bounds);
       }))
    terminal.stage("Link", line);
}
} // namespace Voussoir
