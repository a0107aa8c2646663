// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/samples/chain_diagnosis.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>

namespace Voussoir
{
namespace
{
double mean_of(const std::vector<double> &values)
{
  return std::accumulate(values.begin(), values.end(), 0.) / values.size();
}

/** The halves of chains, less their means. */
class Halves
{
public:
  explicit Halves(const std::vector<std::vector<double>> &chains)
      : n(chains[0].size() / 2)
  {
    std::vector<double> means;
    for (const auto &chain : chains)
      for (const auto begin : {chain.begin(), chain.end() - n})
      {
        parts.emplace_back(begin, begin + n);
        means.push_back(mean_of(parts.back()));
        for (double &value : parts.back())
          value -= means.back();
      }
    variance = autocovariance(0);
    within = variance * n / (n - 1.);
    const double mean = mean_of(means);
    double between = 0.;
    for (const double of_part : means)
      between += (of_part - mean) * (of_part - mean) / (means.size() - 1.);
    all = variance + between;
  }
  double mixing() const { return std::sqrt(all / within); }
  std::size_t length() const { return n; }
  /** rho_t. */
  double correlation(const std::size_t t) const
  {
    return 1. - (variance - autocovariance(t)) / all;
  }

private:
  double autocovariance(const std::size_t t) const
  {
    double sum = 0.;
    for (const auto &part : parts)
      sum += std::inner_product(part.begin() + t, part.end(), part.begin(), 0.);
    return sum / (n * parts.size());
  }

  const std::size_t n;
  std::vector<std::vector<double>> parts;
  double variance, within, all;
};

/** 1 + 2 sum rho_t by the initial monotone sequence. */
double correlation_time(const Halves &halves)
{
  double sum = -1., previous = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t + 1 < halves.length(); t += 2)
  {
    const double pair = halves.correlation(t) + halves.correlation(t + 1);
    if (!(pair > 0.))
      break;
    previous = std::min(previous, pair);
    sum += 2. * previous;
  }
  return sum;
}
} // namespace

ChainDiagnosis diagnose(const std::vector<std::vector<double>> &chains,
                        const double no_deviation)
{
  ChainDiagnosis found;
  double n = 0., squares = 0.;
  for (const auto &chain : chains)
  {
    n += chain.size();
    found.mean += std::accumulate(chain.begin(), chain.end(), 0.);
  }
  found.mean /= n;
  for (const auto &chain : chains)
    for (const double value : chain)
      squares += (value - found.mean) * (value - found.mean);
  found.deviation = std::sqrt(squares / n);
  found.effective = n;
  if (!(found.deviation > no_deviation))
  {
    found.deviation = 0.;
    return found;
  }
  const Halves halves(chains);
  found.mixing = halves.mixing();
  // A walk that turns back may do better than independent samples.
  found.effective = n / std::max(correlation_time(halves), 1. / std::log10(n));
  return found;
}
} // namespace Voussoir
