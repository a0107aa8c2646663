// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/run/sweep/sweep_factors.h>
#include <voussoir/run/sweep/sweep_results.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/** A difference of load factors, over the larger, that says nothing. */
constexpr double same_factor = 1e-6;

/** True if a load factor is less than another by more than proofs differ. */
bool is_less(const double a, const double b)
{
  return b - a > same_factor * std::max(std::abs(a), std::abs(b));
}
} // namespace

std::optional<double> factor_of(const SweepRun &run)
{
  return number_at(run.summary, "load_factor/carried");
}

bool is_more_critical(const SweepRun &a, const SweepRun &b)
{
  const double of_a = *factor_of(a), of_b = *factor_of(b);
  if (a.seeks_least != b.seeks_least)
    return is_less(std::abs(of_a), std::abs(of_b));
  return a.seeks_least ? is_less(of_b, of_a) : is_less(of_a, of_b);
}

std::optional<FactorExtremes> extreme_factors(const std::vector<SweepRun> &runs)
{
  std::optional<FactorExtremes> found;
  std::vector<double> factors(runs.size());
  for (std::size_t k = 0; k < runs.size(); ++k)
  {
    const std::optional<double> factor = factor_of(runs[k]);
    if (!factor || !std::isfinite(*factor))
      continue;
    factors[k] = *factor;
    if (!found)
      found = {k, k, {}, {}};
    if (is_less(factors[k], factors[found->least]))
      found->least = k;
    if (is_less(factors[found->greatest], factors[k]))
      found->greatest = k;
    std::optional<std::size_t> &end =
        runs[k].seeks_least ? found->lower : found->upper;
    if (!end || is_more_critical(runs[k], runs[*end]))
      end = k;
  }
  return found;
}

std::string words_of_critical(const FactorExtremes &extremes)
{
  return extremes.has_both() ? "the nearest to zero"
         : extremes.upper    ? "the least"
                             : "the greatest";
}

std::size_t FactorExtremes::critical(const std::vector<SweepRun> &runs) const
{
  if (!has_both())
    return upper ? *upper : *lower;
  return is_more_critical(runs[*lower], runs[*upper]) ? *lower : *upper;
}
} // namespace Voussoir
