// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_samples_chain_diagnosis_h
#define voussoir_analyses_samples_chain_diagnosis_h

#include <cmath>
#include <vector>

namespace Voussoir
{
/**
 * What several chains of a random walk tell of one quantity: its mean, and how
 * far that may be trusted.
 */
struct ChainDiagnosis
{
  /**
   * The mean and the standard deviation of all samples.
   * @{
   */
  double mean = 0., deviation = 0.;
  /** @} */
  /**
   * The effective number of samples: that of independent ones whose mean has
   * the same error.
   */
  double effective = 0.;
  /**
   * Split R-hat: the deviation in all half chains together over that within
   * each; one if they have forgotten where they began.
   */
  double mixing = 1.;

  /** The standard error of the mean. */
  double error() const
  {
    return deviation > 0. ? deviation / std::sqrt(effective) : 0.;
  }
};

/**
 * Diagnose a quantity by the halves of @p chains, n samples of each, after
 * Gelman and Rubin (*Statistical Science* 7 (1992), 457) and Vehtari, Gelman,
 * Simpson, Carpenter and Buerkner (*Bayesian Analysis* 16 (2021), 667): with
 * the variance W within the halves and var+ of all of them, R-hat^2 = var+ / W,
 * and the correlation of samples t apart is
 *
 *     rho_t = 1 - (W - C_t) / var+,
 *
 * C_t their mean autocovariance. The effective number is that of all samples
 * over 1 + 2 sum rho_t, summed by pairs of neighbours up to the first that is
 * negative, none larger than the one before: the initial monotone sequence of
 * Geyer (*Statistical Science* 7 (1992), 473). Halves that do not agree have
 * correlations that stay, so that it is small.
 *
 * @param chains of equal lengths, at least four.
 * @param no_deviation deviations that are rounding.
 */
ChainDiagnosis diagnose(const std::vector<std::vector<double>> &chains,
                        double no_deviation);
} // namespace Voussoir

#endif
