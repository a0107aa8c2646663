// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_sample_analysis_h
#define voussoir_analyses_sample_analysis_h

#include <voussoir/analyses/analysis.h>
#include <voussoir/analyses/samples/state_samples.h>

namespace Voussoir
{
/** The mean and the spread of forces among all states, by samples of them. */
class SampleAnalysis : public FurtherAnalysis
{
public:
  std::string name() const override { return "samples"; }
  std::string section() const override { return "Ranges"; }
  void add_parameters(dealii::ParameterHandler &prm) override;
  void check(const Scene &scene) const override;
  void answer(AnalysisOutcome &outcome,
              const AnalysisContext &context) const override;

  /**
   * The samples that are wanted; none by default.
   *
   * @throws InputError if they are too few to tell anything.
   */
  std::optional<SamplesWanted> wanted() const;

private:
  SamplesWanted of_samples;
};
} // namespace Voussoir

#endif
