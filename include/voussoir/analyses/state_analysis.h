// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_state_analysis_h
#define voussoir_analyses_state_analysis_h

#include <voussoir/analyses/analysis.h>

namespace Voussoir
{
/** A state that carries the loads, and what else is asked of all of them. */
class StateAnalysis : public Analysis
{
public:
  /** @param further must outlive this object. */
  explicit StateAnalysis(const FurtherAnalyses &further) : further(further) {}
  std::string name() const override { return "state"; }
  std::string meaning() const override
  {
    return "forces that carry the loads, or the mechanism in which the packing "
           "collapses.";
  }
  std::string sections() const override;
  bool takes_forces() const override { return true; }
  void check(const Scene &scene) const override;
  AnalysisOutcome answer(SceneData data,
                         const AnalysisContext &context) const override;

private:
  const FurtherAnalyses &further;
};
} // namespace Voussoir

#endif
