// SPDX-License-Identifier: LGPL-2.1-or-later

// The largest flow through a network: one of known size, and in random networks
// that it is the capacity of the cut that comes with it, which proves both.

#include <voussoir/scene/proofs/network.h>

#include "tests.h"
#include <random>
#include <vector>

namespace test_network
{
using namespace Voussoir;

/** Two ways of capacity 3 and 2, of which the second is one way only. */
void try_two_ways()
{
  Network network(5);
  network.connect(0, 1, 3, 3);
  network.connect(1, 3, 4, 0);
  network.connect(0, 2, 9, 0);
  network.connect(2, 3, 2, 0);
  network.connect(3, 2, 7, 0);
  check("flow by two ways", network.largest_flow(0, 3, 4) == 5);
  check("  source cut off", network.is_cut_off(0) && network.is_cut_off(2));
  check("  sink not", !network.is_cut_off(1) && !network.is_cut_off(3));
}

/** Pairs of edges between vertices taken at random, also several of a pair. */
void try_random(const unsigned int seed)
{
  struct Pair
  {
    unsigned int from, to;
    Network::Units there, back;
  };
  std::mt19937 random(seed);
  const unsigned int n = 40, n_pairs = 120;
  std::vector<Pair> pairs(n_pairs);
  Network network(n_pairs);
  for (Pair &pair : pairs)
  {
    pair.from = random() % n;
    pair.to = (pair.from + 1 + random() % (n - 1)) % n;
    pair.there = random() % 1000;
    pair.back = random() % 1000;
    network.connect(pair.from, pair.to, pair.there, pair.back);
  }
  const Network::Units flow = network.largest_flow(0, n - 1, n);
  Network::Units cut = 0;
  for (const Pair &pair : pairs)
    if (network.is_cut_off(pair.from) != network.is_cut_off(pair.to))
      cut += network.is_cut_off(pair.from) ? pair.there : pair.back;
  check("random network " + std::to_string(seed),
        flow > 0 && flow == cut && network.is_cut_off(0) &&
            !network.is_cut_off(n - 1));
}

void run()
{
  try_two_ways();
  for (unsigned int seed = 1; seed <= 6; ++seed)
    try_random(seed);
}

const RoomTest test("network", run);
} // namespace test_network
