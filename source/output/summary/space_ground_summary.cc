// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/summary/space_ground_summary.h>
#include <voussoir/scene/proofs/space_reactions.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Voussoir
{
namespace
{
using dealii::Tensor;

/** The supports that are said; files have all. */
constexpr std::size_t n_supports_said = 8;
/** A component, over the largest reaction, that is rounding. */
constexpr double rounding_of_reaction = 1e-9;

/** The largest reaction, beside which others may be rounding. */
double largest_of(const std::vector<SpaceReaction> &all)
{
  double largest = 0.;
  for (const SpaceReaction &of : all)
    largest = std::max(largest, of.force.norm());
  return largest;
}

/** A force without what is rounding beside @p largest. */
Tensor<1, 3> without_rounding(Tensor<1, 3> force, const double largest)
{
  for (unsigned int i = 0; i < 3; ++i)
    if (std::abs(force[i]) <= rounding_of_reaction * largest)
      force[i] = 0.;
  return force;
}

nlohmann::ordered_json json_of(const Tensor<1, 3> &v)
{
  return {v[0], v[1], v[2]};
}
} // namespace

nlohmann::ordered_json json_of_reactions(const SpaceResults &answer)
{
  const std::vector<SpaceReaction> &all = answer.reactions;
  const double largest = largest_of(all);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const SpaceReaction &of : all)
    list.push_back({{"centroid", json_of(of.support.centroid)},
                    {"normal", json_of(of.support.normal)},
                    {"area", of.support.area},
                    {"reaction", json_of(without_rounding(of.force, largest))},
                    {"moment", json_of(of.moment)},
                    {"at", json_of(of.place)}});
  return list;
}

void show_reactions(Terminal &terminal, const SpaceResults &answer)
{
  const std::vector<SpaceReaction> &all = answer.reactions;
  if (all.empty())
    return;
  const double largest = largest_of(all);
  const auto words = [&](const Tensor<1, 3> &v) {
    const Tensor<1, 3> shown = without_rounding(v, largest);
    return text("(", shown[0], ", ", shown[1], ", ", shown[2], ")");
  };
  Tensor<1, 3> sum;
  for (const SpaceReaction &of : all)
    sum += of.force;
  std::string line =
      text(words(sum), " on the packing, of ", counted(all.size(), "support"));
  for (std::size_t k = 0;
       all.size() > 1 && k < all.size() && k < n_supports_said; ++k)
    line += text(k == 0 ? ": " : ", ", words(all[k].force), " at ",
                 text_of_point(all[k].support.centroid));
  if (all.size() > n_supports_said)
    line += text(", and ", all.size() - n_supports_said, " more");
  terminal.stage("Reactions", line);
}
} // namespace Voussoir
