// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_factor_analysis_h
#define voussoir_analyses_factor_analysis_h

#include <voussoir/analyses/analysis.h>
#include <voussoir/analyses/factors/factor_entries.h>

namespace Voussoir
{
/** The factor of loads or strengths that is carried: `Load factor`. */
class FactorAnalysis : public Analysis
{
public:
  std::string name() const override { return "load factor"; }
  std::string meaning() const override
  {
    return "the greatest factor of the live loads that is carried, or the "
           "least, between two proofs: forces that balance the loads at it, "
           "and a mechanism that bounds it.";
  }
  std::string sections() const override { return "Live loads, Load factor"; }
  void add_parameters(dealii::ParameterHandler &prm) override
  {
    entries.add_parameters(prm);
  }
  bool has_live_loads() const override { return true; }
  AnalysisOutcome answer(SceneData data,
                         const AnalysisContext &context) const override;

private:
  FactorEntries entries;
};
} // namespace Voussoir

#endif
