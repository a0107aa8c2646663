// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_random_h
#define voussoir_base_random_h

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>

namespace Voussoir
{
/**
 * Random numbers that a seed determines on every machine: Boost's generator and
 * distribution, unlike the standard library's, are specified to the last bit.
 */
class Random
{
public:
  /** Equal seeds give equal numbers. */
  explicit Random(const unsigned int seed) : engine(seed) {}

  /** A number drawn uniformly from [0, 1). */
  double operator()() { return uniform(engine); }
  /** One of the normal distribution with mean zero and variance one. */
  double normal() { return of_normal(engine); }

private:
  boost::random::mt19937_64 engine;
  boost::random::uniform_01<double> uniform;
  boost::random::normal_distribution<double> of_normal;
};
} // namespace Voussoir

#endif
