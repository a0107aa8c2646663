// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/invalid_index.h>
#include <voussoir/packing/straight_runs.h>

#include <map>
#include <utility>

namespace Voussoir
{
namespace
{
/** The largest difference of two unit normals that counts as rounding. */
constexpr double straightness = 1e-9;

/** For each edge the one that follows it on a straight line, or none. */
std::vector<unsigned int>
followers(const std::vector<Packing<2>::BoundaryEdge> &edges)
{
  using Coordinates = std::pair<double, double>;
  std::multimap<Coordinates, unsigned int> by_start;
  for (unsigned int k = 0; k < edges.size(); ++k)
    by_start.insert({{edges[k].start[0], edges[k].start[1]}, k});

  std::vector<unsigned int> next(edges.size(), invalid_index);
  for (unsigned int k = 0; k < edges.size(); ++k)
  {
    const auto range = by_start.equal_range({edges[k].end[0], edges[k].end[1]});
    for (auto other = range.first; other != range.second; ++other)
      if ((edges[other->second].normal - edges[k].normal).norm() <=
          straightness)
        next[k] = other->second;
  }
  return next;
}
} // namespace

std::vector<StraightRun>
straight_runs(const std::vector<Packing<2>::BoundaryEdge> &edges)
{
  const std::vector<unsigned int> next = followers(edges);
  std::vector<bool> follows(edges.size(), false);
  for (const unsigned int k : next)
    if (k != invalid_index)
      follows[k] = true;

  std::vector<StraightRun> runs;
  for (unsigned int k = 0; k < edges.size(); ++k)
    if (!follows[k])
    {
      StraightRun run = {edges[k].start, {}, {}};
      for (unsigned int member = k; member != invalid_index;
           member = next[member])
      {
        run.edges.push_back(member);
        run.end = edges[member].end;
      }
      runs.push_back(std::move(run));
    }
  return runs;
}
} // namespace Voussoir
