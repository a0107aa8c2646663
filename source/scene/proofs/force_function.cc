// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/scene/proofs/displacement_jumps.h>
#include <voussoir/scene/proofs/force_function.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
using dealii::Tensor;

double ForceFunction::operator()(const InterfaceForces &forces) const
{
  double sum = 0.;
  for (const Term &term : terms)
  {
    const std::array<double, 2> ends = forces.ends(term.interface);
    sum += term.at_ends[0] * ends[0] + term.at_ends[1] * ends[1] +
           term.tangential * forces.tangential[term.interface];
  }
  for (const LinkTerm &term : links)
    sum += term.factor * forces.in_links[term.link];
  return sum;
}

ForceFunction ForceFunction::times(const double factor) const
{
  ForceFunction product = *this;
  for (Term &term : product.terms)
  {
    for (double &of_end : term.at_ends)
      of_end *= factor;
    term.tangential *= factor;
  }
  for (LinkTerm &term : product.links)
    term.factor *= factor;
  return product;
}

ForceFunction normal_force(const unsigned int e)
{
  return {{{e, {{1., 1.}}, 0.}}, {}};
}

ForceFunction couple_about(const unsigned int e, const double at)
{
  return {{{e, {{0.5 + at, at - 0.5}}, 0.}}, {}};
}

ForceFunction tangential_force(const unsigned int e)
{
  return {{{e, {{0., 0.}}, 1.}}, {}};
}

ForceFunction force_of_link(const unsigned int k)
{
  return {{}, {{k, 1.}}};
}

ForceFunction reaction(const Packing<2> &packing,
                       const StraightRun &support,
                       const Tensor<1, 2> &direction)
{
  const auto &interfaces = packing.interfaces();
  const unsigned int first = interfaces.size() - packing.n_supports();
  ForceFunction sum;
  for (const unsigned int k : support.edges)
  {
    const Packing<2>::Interface &i = interfaces[first + k];
    const double normal = i.normal * direction;
    sum.terms.push_back(
        {first + k, {{normal, normal}}, i.tangent() * direction});
  }
  return sum;
}

ForceBound bound_of(const Scene &scene,
                    const ForceFunction &function,
                    const Motion &motion)
{
  InterfaceJumps jumps = jumps_of(scene.packing, motion);
  double largest = jumps.largest_displacement;
  for (const ForceFunction::Term &term : function.terms)
  {
    for (unsigned int k = 0; k < 2; ++k)
    {
      jumps.openings[term.interface][k] += term.at_ends[k];
      largest = std::max(largest, std::abs(term.at_ends[k]));
    }
    jumps.sliding[term.interface] += term.tangential;
    largest = std::max(largest, std::abs(term.tangential));
  }
  ForceBound found = {-work_of_loads(scene, motion), 0.};
  for (unsigned int e = 0; e < jumps.sliding.size(); ++e)
  {
    const JointLimits::Resistance joint =
        scene.limits(e).resistance(jumps.openings[e], jumps.sliding[e]);
    found.bound += joint.dissipation;
    found.closing_violation = std::max(found.closing_violation, joint.closing);
  }
  std::vector<double> elongations;
  for (unsigned int k = 0; k < scene.links.size(); ++k)
    elongations.push_back(elongation(scene, k, motion));
  for (const ForceFunction::LinkTerm &term : function.links)
  {
    // The work of the forces of rest on the motion is in that of the loads.
    found.bound += scene.links[term.link].rest() * term.factor;
    elongations[term.link] += term.factor;
    largest = std::max(largest, std::abs(term.factor));
  }
  for (unsigned int k = 0; k < scene.links.size(); ++k)
    found.bound += scene.links[k].dissipation(elongations[k]);
  found.closing_violation /= largest;
  return found;
}
} // namespace Voussoir
