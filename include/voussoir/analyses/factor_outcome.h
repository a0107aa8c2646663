// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_factor_outcome_h
#define voussoir_analyses_factor_outcome_h

#include <voussoir/analyses/analysis.h>
#include <voussoir/analyses/factors/load_factor.h>

#include <optional>
#include <string>

namespace Voussoir
{
/** What was found, and the scene that its forces are in equilibrium in. */
struct FactorSearch
{
  /** The factor, or the collapse. */
  LoadFactorAnswer answer;
  /** The scene at the factor; or the one that collapses. */
  Scene scene;
  /** What the factor multiplies; none of strengths. */
  std::optional<LiveLoads> live = {};
};

/**
 * The state at the factor of a search, which is judged, or the collapse;
 * without results beside.
 *
 * @param found whose forces, or whose collapse, and scene are taken.
 * @param record how they were found.
 * @param stage what the terminal says of that.
 * @param has_dead_loads true if it is dead loads that collapse.
 * @throws SolverError if the state does not carry its loads.
 */
AnalysisOutcome outcome_of(FactorSearch &found,
                           SolverRecord record,
                           const std::string &stage,
                           bool has_dead_loads,
                           const AnalysisContext &context);

/** The mechanism of the factor, which is taken; none without one. */
std::optional<MotionBeside> mechanism_of(FactorSearch &found);
} // namespace Voussoir

#endif
