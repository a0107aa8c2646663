// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_settlement_analysis_h
#define voussoir_analyses_settlement_analysis_h

#include <voussoir/analyses/analysis.h>
#include <voussoir/analyses/ranges/settlement.h>

namespace Voussoir
{
/**
 * What the blocks do where supports move, as the section `Supports` says; its
 * forces take the place of those that were found.
 */
class SettlementAnalysis : public FurtherAnalysis
{
public:
  std::string name() const override { return "settlement"; }
  void answer(AnalysisOutcome &outcome,
              const AnalysisContext &context) const override;
};

/** A line for people on the supports, and how many interfaces move. */
std::string description_of(const Scene &scene, const Settlement &settlement);
} // namespace Voussoir

#endif
