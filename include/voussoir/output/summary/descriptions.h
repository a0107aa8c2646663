// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_summary_descriptions_h
#define voussoir_output_summary_descriptions_h

#include <voussoir/output/results.h>

#include <string>

namespace Voussoir
{
/** How many interfaces have their ranges, and of which kinds they are. */
struct CountOfRanges
{
  /** Count. */
  explicit CountOfRanges(const Ranges &ranges);

  unsigned int wanted = 0;     /**< that were asked for */
  unsigned int determined = 0; /**< with the same forces in all states */
  unsigned int unbounded = 0;  /**< with forces of any size */
};

/** How many interfaces a settlement opens or lets slide. */
struct CountOfJumps
{
  /** Count. */
  CountOfJumps(const Scene &scene, const Settlement &settlement);

  unsigned int open = 0;    /**< all along */
  unsigned int hinges = 0;  /**< at one end only */
  unsigned int sliding = 0; /**< along themselves */
};

/** @{ */
/** A line for people on a part of the results. */
std::string description_of(const LoadFactor &factor);
std::string description_of(const Scene &scene, const Settlement &settlement);
std::string description_of(const Ranges &ranges);
std::string description_of(const StateSamples &samples);
/** @} */

/** The law of friction, and what it means for what is carried. */
std::string description_of_law(const Scene &scene);
} // namespace Voussoir

#endif
