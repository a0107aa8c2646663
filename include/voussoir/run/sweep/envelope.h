// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_sweep_envelope_h
#define voussoir_run_sweep_envelope_h

#include <voussoir/run/sweep/sweep_layout.h>

#include <cstddef>
#include <vector>

namespace Voussoir
{
/** The load factors that all curves of a sweep carry; see SweepLayout. */
struct Envelope
{
  /** @{ */
  /**
   * For each value along x the number of the run with the least of the greatest
   * factors, and with the greatest of the least ones; SweepLayout::no_run where
   * none is finite, and where the dead loads of some curve collapse or it
   * has no answer.
   */
  std::vector<std::size_t> upper, lower;
  /** @} */
  /** The most critical run of each curve, or no_run. */
  std::vector<std::size_t> of_curve;

  /** True if there is more than one curve, and a factor. */
  bool exists() const;
};

/** The envelope of the curves of @p layout. */
Envelope envelope_of(const SweepLayout &layout,
                     const std::vector<SweepRun> &runs);
} // namespace Voussoir

#endif
