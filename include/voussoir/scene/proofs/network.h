// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_proofs_network_h
#define voussoir_scene_proofs_network_h

#include <boost/graph/properties.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace Voussoir
{
/**
 * A network of vertices and edges with capacities, and the largest flow from a
 * source to a sink, found by Boykov and Kolmogorov's method of the Boost Graph
 * Library. Capacities are integers, so that sums are exact.
 */
class Network
{
public:
  /** The number of a vertex. */
  using Vertex = std::uint32_t;
  /** Of capacities and flows. */
  using Units = std::int64_t;

  /** @param n_pairs the number of calls of connect() to come, or less. */
  explicit Network(std::size_t n_pairs);

  /** Add an edge from one vertex to another, and one back. */
  void connect(Vertex from, Vertex to, Units capacity, Units capacity_back);

  /**
   * The largest flow; to be asked for once.
   *
   * @param n the number of vertices.
   */
  Units largest_flow(Vertex source, Vertex sink, Vertex n);

  /** True if the largest flow cuts @p vertex off from the sink. */
  bool is_cut_off(const Vertex vertex) const
  {
    return colours[vertex] == boost::black_color;
  }

private:
  /** The vertices and the capacity of each edge, those of a pair in turn. */
  std::vector<std::pair<Vertex, Vertex>> ends;
  std::vector<Units> capacities;
  /** Of each vertex after largest_flow(). */
  std::vector<boost::default_color_type> colours;
};
} // namespace Voussoir

#endif
