// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/scene/proofs/displacement_jumps.h>

#include <algorithm>

namespace Voussoir
{
using dealii::Tensor;

InterfaceJumps jumps_of(const Packing<2> &packing, const Motion &motion)
{
  InterfaceJumps jumps;
  double &largest = jumps.largest_displacement;
  for (const Tensor<1, 2> &u : motion.displacement)
    largest = std::max(largest, u.norm());
  const auto &interfaces = packing.interfaces();
  const unsigned int first_support = interfaces.size() - packing.n_supports();
  const auto of_ground = [&](const unsigned int e, const dealii::Point<2> &x) {
    return motion.of_supports.empty()
               ? Tensor<1, 2>()
               : motion.of_supports[e - first_support].at(
                     x - interfaces[e].midpoint());
  };
  const auto displacement = [&](const unsigned int c, const unsigned int e,
                                const dealii::Point<2> &x) {
    const Tensor<1, 2> u = c == packing.ground()
                               ? of_ground(e, x)
                               : motion.at(c, x - packing.centre(c));
    largest = std::max(largest, u.norm());
    return u;
  };
  jumps.openings.reserve(interfaces.size());
  jumps.sliding.reserve(interfaces.size());
  for (unsigned int e = 0; e < interfaces.size(); ++e)
  {
    const Packing<2>::Interface &i = interfaces[e];
    const auto jump_at = [&](const dealii::Point<2> &x) {
      return displacement(i.cell_plus, e, x) - displacement(i.cell_minus, e, x);
    };
    const Tensor<1, 2> start = jump_at(i.start), end = jump_at(i.end);
    jumps.openings.push_back({{start * i.normal, end * i.normal}});
    jumps.sliding.push_back(0.5 * ((start + end) * i.tangent()));
  }
  return jumps;
}

double
elongation(const Scene &scene, const unsigned int k, const Motion &motion)
{
  const Link &link = scene.links[k];
  const auto along = [&](const unsigned int c, const dealii::Point<2> &x) {
    return c == scene.packing.ground()
               ? 0.
               : motion.at(c, x - scene.packing.centre(c)) * link.direction;
  };
  return along(link.cell_plus, link.on_plus) -
         along(link.cell_minus, link.on_minus);
}

double work_of_loads(const Scene &scene, const Motion &motion)
{
  double work = 0.;
  for (unsigned int c = 0; c < scene.packing.n_cells(); ++c)
  {
    work += scene.load[c] * motion.displacement[c];
    if (!motion.rotation.empty())
      work += scene.load_torque[c] * motion.rotation[c];
  }
  for (unsigned int k = 0; k < scene.links.size(); ++k)
    work -= scene.links[k].rest() * elongation(scene, k, motion);
  return work;
}
} // namespace Voussoir
