// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_sweep_sweep_factors_h
#define voussoir_run_sweep_sweep_factors_h

#include <voussoir/run/sweep/repeated_run.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** The load factor of a run, which may be infinite; none if it has none. */
std::optional<double> factor_of(const SweepRun &run);

/**
 * True if the factor of @p a is nearer to those that are not carried than that
 * of @p b, by more than proofs differ; both are finite. It is less where both
 * look for the greatest factor, greater where both look for the least, and else
 * nearer to zero.
 */
bool is_more_critical(const SweepRun &a, const SweepRun &b);

/** Runs by their finite load factors, each the first of those that have it. */
struct FactorExtremes
{
  /** @{ */
  /** The least and the greatest of all. */
  std::size_t least, greatest;
  /** @} */
  /** The least of the greatest factors, if some are looked for. */
  std::optional<std::size_t> upper;
  /** The greatest of the least factors. */
  std::optional<std::size_t> lower;

  /** True if both ends are looked for. */
  bool has_both() const { return upper && lower; }
  /** The run that says most: of both that whose factor is nearer to zero. */
  std::size_t critical(const std::vector<SweepRun> &runs) const;
};

/** "the least", "the greatest" or "the nearest to zero": which factor is the
 * critical one. */
std::string words_of_critical(const FactorExtremes &extremes);

/** @return nothing if no run has a finite factor. */
std::optional<FactorExtremes>
extreme_factors(const std::vector<SweepRun> &runs);
} // namespace Voussoir

#endif
