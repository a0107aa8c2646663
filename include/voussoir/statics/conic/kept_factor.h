// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_kept_factor_h
#define voussoir_statics_conic_kept_factor_h

#include <voussoir/base/journal.h>
#include <voussoir/statics/conic/factor_bounds.h>

#include <limits>
#include <optional>

namespace Voussoir
{
/** All that ProvenFactor knows on its way, as it is kept in a Journal. */
struct KeptFactor
{
  /** @{ */
  /** Of SelfDual: where it is, the best point so far, its merit, and the
   * iteration at which proofs were looked for last. */
  SelfDual::Progress progress = {};
  std::optional<SelfDual::Point> best = {};
  double least_merit = 0.;
  unsigned int last_trial = 0;
  /** @} */
  /** True if ProvenFactor::set_carried() is not needed any more. */
  bool has_taken_known = false;
  /** @{ */
  /** A state far from the limits, and a motion far from closing joints. */
  std::optional<FactorState> anchor = {};
  std::optional<FactorMotion> open = {};
  /** @} */
  /** @{ */
  /** The best proofs. */
  std::optional<FactorState> best_state = {};
  bool has_state = false;
  std::optional<FactorMotion> best_motion = {};
  double least_bound = std::numeric_limits<double>::infinity();
  /** @} */
};

/** @{ */
/** As a tree, and back, to the bit. */
Journal::Json json_of(const KeptFactor &kept);
KeptFactor kept_factor_of(const Journal::Json &json);
/** @} */
} // namespace Voussoir

#endif
