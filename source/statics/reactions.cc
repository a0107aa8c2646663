// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/straight_runs.h>
#include <voussoir/statics/reactions.h>

namespace Voussoir
{
using dealii::Tensor;

std::vector<Reaction> reactions(const Scene &scene,
                                const InterfaceForces &forces)
{
  const auto &interfaces = scene.packing.interfaces();
  const unsigned int first = interfaces.size() - scene.packing.n_supports();
  std::vector<Packing::BoundaryEdge> supports;
  for (unsigned int e = first; e < interfaces.size(); ++e)
  {
    const Packing::Interface &i = interfaces[e];
    supports.push_back({i.cell_minus, i.start, i.end, i.normal, i.length});
  }

  std::vector<Reaction> reactions;
  for (const StraightRun &run : straight_runs(supports))
  {
    Reaction reaction = {run.start, run.end, {}};
    for (const unsigned int k : run.edges)
      reaction.force += forces.on_cell_minus(interfaces[first + k], first + k);
    reactions.push_back(reaction);
  }
  return reactions;
}

GroundBalance balance_on_ground(const Scene &scene,
                                const std::vector<Reaction> &reactions)
{
  GroundBalance balance = {{}, {}, 0.};
  double size = 0.;
  for (const Tensor<1, 2> &F : scene.load)
  {
    balance.load += F;
    size += F.norm();
  }
  for (const Reaction &reaction : reactions)
    balance.reaction += reaction.force;
  if (size > 0.)
    balance.imbalance = (balance.load + balance.reaction).norm() / size;
  return balance;
}
} // namespace Voussoir
