// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_range_analysis_h
#define voussoir_analyses_range_analysis_h

#include <voussoir/analyses/analysis.h>
#include <voussoir/analyses/ranges/range_entries.h>

namespace Voussoir
{
/** How much forces may differ among all states: the section `Ranges`. */
class RangeAnalysis : public FurtherAnalysis
{
public:
  std::string name() const override { return "ranges"; }
  std::string section() const override { return "Ranges"; }
  void add_parameters(dealii::ParameterHandler &prm) override
  {
    entries.add_parameters<2>(prm);
  }
  void check(const Scene &scene) const override;
  void answer(AnalysisOutcome &outcome,
              const AnalysisContext &context) const override;

private:
  RangeEntries entries;
};

/** A line for people on how many interfaces and supports have ranges. */
std::string description_of(const Ranges &ranges, const Scene &scene);
} // namespace Voussoir

#endif
