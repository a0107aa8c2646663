// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_capacity_analysis_h
#define voussoir_analyses_capacity_analysis_h

#include <voussoir/analyses/analysis.h>
#include <voussoir/analyses/capacity/capacity_curve.h>

namespace Voussoir
{
/** The factor of the live loads along the mechanism: `Capacity`. */
class CapacityAnalysis : public Analysis
{
public:
  std::string name() const override { return "capacity"; }
  std::string meaning() const override
  {
    return "the factor of the live loads while the blocks go along their "
           "mechanism, at displacements of any size, until it is zero; or "
           "with supports that move as 'Supports/Displacement' says, while "
           "the dead loads are carried; each between two proofs.";
  }
  std::string sections() const override { return "Live loads, Capacity"; }
  void add_parameters(dealii::ParameterHandler &prm) override;
  bool has_live_loads() const override { return true; }
  void check(const Scene &scene) const override;
  AnalysisOutcome answer(SceneData data,
                         const AnalysisContext &context) const override;

private:
  CapacityWanted wanted(const Packing<2> &packing) const;

  std::string point, direction = "1, 0";
  unsigned int n_points = 20;
  double largest = 0.;
};
} // namespace Voussoir

#endif
