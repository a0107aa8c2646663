// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_range_analysis_h
#define voussoir_analyses_range_analysis_h

#include <voussoir/analyses/analysis.h>
#include <voussoir/analyses/ranges/ranges.h>

namespace Voussoir
{
/** How much forces may differ among all states: the section `Ranges`. */
class RangeAnalysis : public FurtherAnalysis
{
public:
  std::string name() const override { return "ranges"; }
  std::string section() const override { return "Ranges"; }
  void add_parameters(dealii::ParameterHandler &prm) override;
  void check(const Scene &scene) const override;
  void answer(AnalysisOutcome &outcome,
              const AnalysisContext &context) const override;

  /**
   * What is wanted of a packing with its supports; nothing by default.
   *
   * @throws InputError if the condition cannot be evaluated or holds on no
   *   interface, a name is that of none, or reactions are wanted and there are
   *   no supports.
   */
  std::optional<RangesWanted> wanted(const Packing<2> &packing) const;

private:
  std::string where = "0", joints;
  bool reactions = false;
  RangeMethod method = RangeMethod::automatic;
};

/** A line for people on how many interfaces and supports have ranges. */
std::string description_of(const Ranges &ranges);
} // namespace Voussoir

#endif
