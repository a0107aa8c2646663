// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/summary/ground_summary.h>
#include <voussoir/scene/proofs/utilisation.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace Voussoir
{
namespace
{
using dealii::Tensor;
using Json = nlohmann::ordered_json;

/** The largest number of supports that the terminal shows. */
constexpr std::size_t n_shown_reactions = 8;

/** The number of most used interfaces in files, and on the terminal. */
constexpr std::size_t n_most_used = 10, n_shown_most_used = 5;

/** A component, over the largest of all forces shown, that is rounding. */
constexpr double rounding = 1e-12;

template <typename Vector>
Json pair(const Vector &v)
{
  return Json::array({v[0], v[1]});
}

/** The force without components that are rounding beside @p largest. */
Tensor<1, 2> shown(Tensor<1, 2> force, const double largest)
{
  for (unsigned int i = 0; i < 2; ++i)
    if (std::abs(force[i]) <= rounding * largest)
      force[i] = 0.;
  return force;
}

/** The sum of the sizes of the loads: what their sum is compared to. */
double size_of_loads(const Scene &scene)
{
  return std::accumulate(scene.load_size.begin(), scene.load_size.end(), 0.);
}

Tensor<1, 2> total_load(const Scene &scene)
{
  return shown(balance_on_ground(scene, {}).load, size_of_loads(scene));
}

GroundBalance balance_of(const Results &results)
{
  return balance_on_ground(results.scene, results.reactions,
                           results.forces.in_links);
}

/** The length of all supports. */
double length_of_supports(const Packing<2> &packing)
{
  const auto &interfaces = packing.interfaces();
  return std::accumulate(
      interfaces.end() - packing.n_supports(), interfaces.end(), 0.,
      [](const double sum, const auto &i) { return sum + i.length; });
}

/** f_n of all supports over their length, negative in compression. */
double mean_normal_stress(const Results &results)
{
  const auto &normal = results.forces.normal;
  const Packing<2> &packing = results.scene.packing;
  return std::accumulate(normal.end() - packing.n_supports(), normal.end(),
                         0.) /
         length_of_supports(packing);
}

/** The largest reaction, beside which others may be rounding. */
double largest_reaction(const Results &results)
{
  double largest = 0.;
  for (const Reaction &reaction : results.reactions)
    largest = std::max(largest, reaction.force.norm());
  return largest;
}

/** The interfaces of which the most of the strength is used, in that order. */
std::vector<std::pair<double, unsigned int>> most_used(const Results &results)
{
  const Utilisation utilisation(results.scene, results.forces);
  std::vector<std::pair<double, unsigned int>> joints;
  for (unsigned int e = 0; e < results.forces.normal.size(); ++e)
    joints.emplace_back(-utilisation(e), e);
  const std::size_t n = std::min(n_most_used, joints.size());
  std::partial_sort(joints.begin(), joints.begin() + n, joints.end());
  joints.resize(n);
  for (auto &[used, e] : joints)
    used = 0. - used;
  return joints;
}
} // namespace

Json loads_summary(const Scene &scene)
{
  Json json = {{"total", pair(total_load(scene))}};
  if (scene.packing.n_supports() == 0)
    return json;
  const double length = length_of_supports(scene.packing);
  json["length_of_supports"] = length;
  json["over_length_of_supports"] = total_load(scene).norm() / length;
  return json;
}

Json ground_summary(const Results &results)
{
  const double largest = largest_reaction(results);
  Json supports = Json::array();
  for (const Reaction &reaction : results.reactions)
  {
    const Tensor<1, 2> force = shown(reaction.force, largest);
    supports.push_back(
        {{"from", pair(reaction.start)},
         {"to", pair(reaction.end)},
         {"reaction", pair(force)},
         {"at", force.norm() > 0. ? pair(reaction.place) : Json(nullptr)}});
  }
  const GroundBalance balance = balance_of(results);
  return {{"load", pair(balance.load)},
          {"reaction", pair(balance.reaction)},
          {"imbalance", balance.imbalance},
          {"mean_normal_stress", mean_normal_stress(results)},
          {"supports", supports}};
}

Json most_used_summary(const Results &results)
{
  Json joints = Json::array();
  for (const auto &[used, e] : most_used(results))
  {
    const Packing<2>::Interface &i = results.scene.packing.interfaces()[e];
    const int other = i.cell_plus == results.scene.packing.ground()
                          ? -1
                          : static_cast<int>(i.cell_plus);
    joints.push_back(
        {{"interface", e},
         {"cells", {i.cell_minus, other}},
         {"at", pair(i.midpoint())},
         {"utilisation", std::isfinite(used) ? Json(used) : Json(nullptr)}});
  }
  return joints;
}

std::string text_of_force(const Tensor<1, 2> &force, const double largest)
{
  const Tensor<1, 2> of = shown(force, largest);
  return text("(", of[0], ", ", of[1], ")");
}

void show_loads(Terminal &terminal, const Scene &scene, const std::string &name)
{
  if (scene.packing.n_supports() == 0)
    return;
  const Tensor<1, 2> total = total_load(scene);
  const double length = length_of_supports(scene.packing);
  terminal.stage(name, text(text_of_force(total, size_of_loads(scene)),
                            " in all, over supports of length ", length,
                            " a stress of ", total.norm() / length));
}

void show_reactions(Terminal &terminal, const Results &results)
{
  if (results.reactions.empty())
    return;
  const double largest = largest_reaction(results);
  const auto words = [&](const Tensor<1, 2> &reaction) {
    return text_of_force(reaction, largest);
  };
  const std::size_t n = results.reactions.size();
  terminal.summary("Reaction",
                   text(words(balance_of(results).reaction), " on ",
                        counted(n, "straight support"), ", mean normal stress ",
                        mean_normal_stress(results)));
  for (std::size_t k = 0; k < std::min(n, n_shown_reactions); ++k)
  {
    const Reaction &of = results.reactions[k];
    terminal.summary("Reaction",
                     text(words(of.force), " from ", text_of_point(of.start),
                          " to ", text_of_point(of.end),
                          shown(of.force, largest).norm() > 0.
                              ? ", at " + text_of_point(of.place)
                              : ""));
  }
  if (n > n_shown_reactions)
    terminal.summary("Reaction", text("and ", n - n_shown_reactions, " more"));
}

void show_most_used(Terminal &terminal, const Results &results)
{
  const auto joints = most_used(results);
  for (std::size_t k = 0; k < std::min(joints.size(), n_shown_most_used); ++k)
  {
    const auto &[used, e] = joints[k];
    const Packing<2> &packing = results.scene.packing;
    const Packing<2>::Interface &i = packing.interfaces()[e];
    terminal.detail("Most used", text(used, " of the strength between ",
                                      packing.describe(i.cell_minus), " and ",
                                      packing.describe(i.cell_plus), " at ",
                                      text_of_point(i.midpoint())));
  }
}
} // namespace Voussoir
