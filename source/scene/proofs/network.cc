// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/scene/proofs/network.h>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/range/iterator_range.hpp>

#include <numeric>

namespace Voussoir
{
namespace
{
/** Each edge has its number, and its reverse that but for the last bit. */
using Graph = boost::compressed_sparse_row_graph<boost::directedS,
                                                 boost::no_property,
                                                 std::uint32_t,
                                                 boost::no_property,
                                                 Network::Vertex,
                                                 std::uint32_t>;
using Edge = Graph::edge_descriptor;
} // namespace

Network::Network(const std::size_t n_pairs)
{
  ends.reserve(2 * n_pairs);
  capacities.reserve(2 * n_pairs);
}

void Network::connect(const Vertex from,
                      const Vertex to,
                      const Units capacity,
                      const Units capacity_back)
{
  ends.emplace_back(from, to);
  ends.emplace_back(to, from);
  capacities.push_back(capacity);
  capacities.push_back(capacity_back);
}

// What is no longer needed is given back: of a large packing it is much.
Network::Units
Network::largest_flow(const Vertex source, const Vertex sink, const Vertex n)
{
  std::vector<std::uint32_t> numbers(ends.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  const Graph graph(boost::edges_are_unsorted_multi_pass, ends.begin(),
                    ends.end(), numbers.begin(), n);
  ends = {};
  std::vector<Edge> edge_of(numbers.size()), reverse(numbers.size());
  numbers = {};
  std::vector<Units> capacity(edge_of.size()), residual(edge_of.size());
  for (const Edge &edge : boost::make_iterator_range(edges(graph)))
  {
    edge_of[graph[edge]] = edge;
    capacity[edge.idx] = capacities[graph[edge]];
  }
  capacities = {};
  for (const Edge &edge : boost::make_iterator_range(edges(graph)))
    reverse[edge.idx] = edge_of[graph[edge] ^ 1U];
  edge_of = {};

  const auto of_edge = [&](auto &values) {
    return boost::make_iterator_property_map(values.begin(),
                                             get(boost::edge_index, graph));
  };
  const auto of_vertex = [&](auto &values) {
    return boost::make_iterator_property_map(values.begin(),
                                             get(boost::vertex_index, graph));
  };
  std::vector<Edge> predecessor(n);
  std::vector<long> distance(n);
  colours.resize(n);
  return boost::boykov_kolmogorov_max_flow(
      graph, of_edge(capacity), of_edge(residual), of_edge(reverse),
      of_vertex(predecessor), of_vertex(colours), of_vertex(distance),
      get(boost::vertex_index, graph), source, sink);
}
} // namespace Voussoir
