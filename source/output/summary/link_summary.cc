// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/summary/link_summary.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

/** The most links that the terminal shows. */
constexpr std::size_t n_shown_links = 12;
/** A force, over the width of its bounds, that is rounding. */
constexpr double rounding_of_link = 1e-9;

/** The lines of the first links, and how many more there are. */
template <typename WordsOf>
std::vector<std::string> lines_of(const Scene &scene, const WordsOf &words_of)
{
  std::vector<std::string> lines;
  const std::size_t n = scene.links.size();
  for (unsigned int k = 0; k < std::min(n, n_shown_links); ++k)
    lines.push_back(scene.links[k].name + ": " + words_of(k));
  if (n > n_shown_links)
    lines.push_back(text("and ", n - n_shown_links, " more"));
  return lines;
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
} // namespace

nlohmann::ordered_json links_summary(const Results &results)
{
  Json list = Json::array();
  for (unsigned int k = 0; k < results.scene.links.size(); ++k)
  {
    const Link &link = results.scene.links[k];
    const double force = results.forces.in_links[k];
    list.push_back({{"name", link.name},
                    {"force", force},
                    {"least", link.least},
                    {"most", link.most},
                    {"utilisation", link.utilisation(force)}});
  }
  return list;
}

void show_link_forces(Terminal &terminal, const Results &results)
{
  for (const std::string &line :
       lines_of(results.scene, [&](const unsigned int k) {
         return words_of_force(results.scene.links[k],
                               results.forces.in_links[k]);
       }))
    terminal.summary("Link", line);
}

void show_links(Terminal &terminal, const Scene &scene)
{
  for (const std::string &line : lines_of(scene, [&](const unsigned int k) {
         const Link &link = scene.links[k];
         return text(scene.packing.describe(link.cell_minus), " at ",
                     text_of_point(link.on_minus), " - ",
                     scene.packing.describe(link.cell_plus), " at ",
                     text_of_point(link.on_plus), ", force from ", link.least,
                     " to ", link.most);
       }))
    terminal.stage("Link", line);
}
} // namespace Voussoir
