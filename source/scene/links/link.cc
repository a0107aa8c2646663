// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/scene/links/link.h>

#include <utility>

namespace Voussoir
{
std::vector<unsigned int> linked_groups(const Packing<2> &packing,
                                        const std::vector<Link> &links,
                                        const Ground ground)
{
  std::vector<std::pair<unsigned int, unsigned int>> pairs;
  for (const Link &link : links)
    pairs.emplace_back(link.cell_minus, link.cell_plus);
  return connected_groups(packing, ground, pairs);
}

std::vector<Link> without_rest(std::vector<Link> links)
{
  for (Link &link : links)
  {
    const double rest = link.rest();
    link.least -= rest;
    link.most -= rest;
  }
  return links;
}
} // namespace Voussoir
