// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/scene/proofs/reactions.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
using dealii::Tensor;

std::vector<StraightRun> straight_supports(const Packing<2> &packing)
{
  std::vector<Packing<2>::BoundaryEdge> supports;
  const auto &interfaces = packing.interfaces();
  for (auto i = interfaces.end() - packing.n_supports(); i != interfaces.end();
       ++i)
    supports.push_back({i->cell_minus, i->start, i->end, i->normal, i->length});
  std::vector<StraightRun> runs = straight_runs(supports);
  std::stable_sort(runs.begin(), runs.end(),
                   [](const StraightRun &one, const StraightRun &other) {
                     return one.start[0] + one.end[0] <
                            other.start[0] + other.end[0];
                   });
  return runs;
}

std::vector<Reaction> reactions(const Scene &scene,
                                const InterfaceForces &forces)
{
  const auto &interfaces = scene.packing.interfaces();
  const unsigned int first = interfaces.size() - scene.packing.n_supports();
  std::vector<Reaction> reactions;
  for (const StraightRun &run : straight_supports(scene.packing))
  {
    Reaction reaction = {
        run.start, run.end, {}, run.start + 0.5 * (run.end - run.start)};
    double normal = 0., moment = 0.;
    const Tensor<1, 2> along =
        (run.end - run.start) / run.start.distance(run.end);
    for (const unsigned int k : run.edges)
    {
      const Packing<2>::Interface &i = interfaces[first + k];
      reaction.force += forces.on_cell_minus(i, first + k);
      normal += forces.normal[first + k];
      moment +=
          forces.normal[first + k] * ((i.midpoint() - run.start) * along) -
          forces.couple(i, first + k);
    }
    if (normal != 0.)
      reaction.place = run.start + moment / normal * along;
    reactions.push_back(reaction);
  }
  return reactions;
}

GroundBalance balance_on_ground(const Scene &scene,
                                const std::vector<Reaction> &reactions,
                                const std::vector<double> &in_links)
{
  // Sums of many numbers of one sign, to be compared to rounding.
  long double load[2] = {0., 0.}, reaction[2] = {0., 0.}, size = 0.;
  for (const Tensor<1, 2> &F : scene.load)
  {
    for (unsigned int i = 0; i < 2; ++i)
      load[i] += F[i];
    size += F.norm();
  }
  for (const Reaction &support : reactions)
    for (unsigned int i = 0; i < 2; ++i)
      reaction[i] += support.force[i];
  for (unsigned int k = 0; k < in_links.size(); ++k)
    for (unsigned int i = 0; i < 2; ++i)
      if (scene.links[k].cell_plus == scene.packing.ground())
        reaction[i] += in_links[k] * scene.links[k].direction[i];

  GroundBalance balance = {{}, {}, 0.};
  for (unsigned int i = 0; i < 2; ++i)
  {
    balance.load[i] = load[i];
    balance.reaction[i] = reaction[i];
  }
  if (size > 0.)
    balance.imbalance =
        std::hypot(load[0] + reaction[0], load[1] + reaction[1]) / size;
  return balance;
}
} // namespace Voussoir
